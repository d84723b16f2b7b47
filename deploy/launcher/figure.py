"""Draws the paper's Fig. 7 from the log of a run."""

import csv
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Sequence

from .failure import Failure
from .foreground import run_in_front
from .log_files import is_open
from .places import Places
from .signals import Signals

# A log that is still being written holds what its recorder has closed: at most about a second is missing.
_CHUNK_PATIENCE_S = 5.0
_CHUNK_POLL_S = 0.2
_PYTHON = "/usr/bin/python3"


def draw_figure(places: Places, logs: Sequence[Path], trial: int, prefix: Path, signals: Signals) -> None:
    """Writes <prefix>.csv, .svg and .png. Failure with the reason where that does not work."""
    def extract(topic: str, table: Path) -> None:
        _run([places.program("scarab-log"), "export", *logs, "--format", "csv",
              "--topic", f"scarab/{topic}", "--trial", str(trial)], table, signals)

    with tempfile.TemporaryDirectory(dir=prefix.parent, prefix=".figure7-") as room:
        behaviour, robot_state = Path(room) / "behaviour.csv", Path(room) / "robot_state.csv"
        extract("behaviour", behaviour)
        patience_ends = time.monotonic() + _CHUNK_PATIENCE_S
        while (is_open(logs[-1]) and not _shows_the_end(behaviour)
               and time.monotonic() < patience_ends):
            signals.wait(_CHUNK_POLL_S)
            extract("behaviour", behaviour)
        extract("robot_state", robot_state)
        script = places.root / "deploy" / "plot" / "figure7.py"
        _run([_PYTHON, script, "--behaviour", behaviour, "--robot-state", robot_state,
              "--output", prefix], None, signals)


def first_trial(results: Path) -> int:
    """Number of the first trial of the table; 1 where it has no such column."""
    try:
        with open(results, newline="") as table:
            row = next(csv.DictReader(table), {})
    except OSError:
        return 1
    number = row.get("trial") or ""
    return int(number) if number.isdigit() else 1


def _shows_the_end(behaviour: Path) -> bool:
    with open(behaviour, newline="") as table:
        states = [row.get("state") or "" for row in csv.DictReader(table)]
    return bool(states) and states[-1].endswith(("DONE", "FAILED"))


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
            name = Path(next(word for word in command if word != _PYTHON)).name
            reason = lines[-1].removeprefix(f"{name}: ") if lines else f"exit code {code}"
            raise Failure(f"{name}: {reason}")
