"""What is drawn and written of an experiment's results: deploy/report does that."""

import sys
import tempfile
from pathlib import Path
from typing import Sequence

from ..failure import Failure
from ..foreground import run_in_front
from ..places import Places, shown
from ..signals import Signals

_PYTHON = "/usr/bin/python3"


class ReportFailure(Failure):
    """The results are whole, but what they look like is not."""


def draw_report(places: Places, directory: Path, signals: Signals) -> None:
    """ReportFailure with the reason where that does not work, Interrupted on a request to stop."""
    script = places.root / "deploy" / "report" / "report.py"
    with tempfile.TemporaryFile() as complaint:
        code = run_in_front([_PYTHON, script, directory, "--bin", places.bin], signals,
                            stdout=complaint, stderr=complaint)
        if code != 0:
            complaint.seek(0)
            lines = complaint.read().decode(errors="replace").strip().splitlines()
            reason = lines[-1] if lines else f"exit code {code}"
            raise ReportFailure(f"the report of {shown(directory)} could not be drawn: {reason}. The results are "
                                f"whole; once that is mended: {shown(script)} {shown(directory)}")


def write_index(directories: Sequence[Path], page: Path) -> None:
    """One page over all of them."""
    from report import write_index as write  # deploy/report is on the path, as deploy/launcher is
    write(list(directories), page)


def say_where(directory: Path) -> None:
    """The lines that say where everything is."""
    figures = sorted(path.name for path in directory.glob("*.svg"))
    things = [("results", "results.csv"), ("summary", "summary.json"), ("report", "report.html"),
              *(("figure" if i == 0 else "", name) for i, name in enumerate(figures)),
              ("configuration", "config")]
    for name, file in things:
        if (directory / file).exists():
            print(f"{name + ':' if name else '':15}{shown(directory / file)}")
    sys.stdout.flush()
