"""Draws the paper's Fig. 7 from the log of a run."""

import csv
import subprocess
import tempfile
from pathlib import Path

from .failure import Failure
from .foreground import run_in_front
from .places import Places
from .signals import Signals

_TOPICS = ("behaviour", "robot_state")


def draw_figure(places: Places, log: Path, trial: int, prefix: Path, signals: Signals) -> None:
    """Writes <prefix>.csv, .svg and .png. Failure with the reason where that does not work."""
    with tempfile.TemporaryDirectory(dir=prefix.parent, prefix=".figure7-") as room:
        tables = []
        for topic in _TOPICS:
            table = Path(room) / f"{topic}.csv"
            _run([places.program("scarab-log"), "csv", log, "--topic", f"scarab/{topic}",
                  "--trial", str(trial)], table, signals)
            tables += [f"--{topic.replace('_', '-')}", table]
        script = places.root / "deploy" / "plot" / "figure7.py"
        _run(["/usr/bin/python3", script, *tables, "--output", prefix], None, signals)


def first_trial(results: Path) -> int:
    """Number of the first trial of the table; 1 where it has no such column."""
    try:
        with open(results, newline="") as table:
            row = next(csv.DictReader(table), {})
    except OSError:
        return 1
    number = row.get("trial") or ""
    return int(number) if number.isdigit() else 1


def _run(command: list, output: "Path | None", signals: Signals) -> None:
    with tempfile.TemporaryFile() as complaint:
        if output is None:
            code = run_in_front(command, signals, subprocess.DEVNULL, complaint)
        else:
            with open(output, "wb") as table:
                code = run_in_front(command, signals, table, complaint)
        if code != 0:
            complaint.seek(0)
            lines = complaint.read().decode(errors="replace").strip().splitlines()
            reason = lines[-1] if lines else f"exit code {code}"
            raise Failure(f"{Path(command[0]).name}: {reason}")
