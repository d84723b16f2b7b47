"""Figures and reports of experiments, from their directories. README.md says what is read and written.

matplotlib is loaded only where something is drawn.
"""

import os
from pathlib import Path
from typing import List, Optional, Sequence

from .failure import ReportError

__all__ = ["ReportError", "write", "write_index"]
_ROOT = Path(__file__).resolve().parents[2]


def write(directory: Path, bin: Optional[Path] = None) -> List[Path]:
    """Draws the figures and writes summary.json and report.html into the experiment's directory.

    `bin` has the program scarab-log, for logs alone. Returns the files written, report.html last; ReportError with one
    line for a person where plan.json or results.csv do not serve, or a finished experiment lacks a log.
    """
    from .directory_report import write_report
    return write_report(Path(directory), bin or default_bin())


def write_index(directories: Sequence[Path], out: Path) -> Path:
    """One page with the figures and findings of several experiments that have been reported."""
    from .page.index_page import write_index_page
    return write_index_page([Path(directory) for directory in directories], Path(out))


def default_bin() -> Path:
    return Path(os.environ.get("SCARAB_BIN") or _ROOT / "build" / "release" / "bin")
