"""Room for logs: the run directory can be written to, and its disk is not about to fill up."""

import os
import shutil
import time
from typing import List, Optional

from ..places import shown
from ..run_directory import RunDirectory
from .finding import Finding, note, ok, problem
from .recorded import RecordedStack
from .subject import Subject

_LEAST_FREE_BYTES = 500 * 1000 * 1000
_SOON_S = 3600.0
_TODAY_S = 24 * 3600.0
_LEAST_AGE_S = 10.0  # of a log, before its growth says anything


def storage(subject: Subject) -> List[Finding]:
    runs = subject.places.runs
    place = next(p for p in (runs, *runs.parents) if p.exists())
    if not os.access(place, os.W_OK):
        return [problem(f"{shown(place)} cannot be written to, so that no run directory can be made",
                        "Give yourself the right to write there, or choose another place: --runs DIR")]
    free = shutil.disk_usage(place).free
    if free < _LEAST_FREE_BYTES:
        return [problem(f"only {_amount(free)} are free in {shown(place)}",
                        "Remove old runs, or choose another place: --runs DIR")]
    filling = [f for f in (_filling(stack, free) for stack in subject.running) if f]
    return filling or [ok(f"{_amount(free)} are free in {shown(place)}")]


def _filling(stack: RecordedStack, free: int) -> Optional[Finding]:
    """A stack that lasts fills the disk some day: when, at its present rate."""
    rate = _bytes_per_s(stack.directory)
    if rate <= 0 or free / rate > _TODAY_S:
        return None
    hours = free / rate / 3600
    text = (f"{_amount(free)} are free, and the log of {shown(stack.directory.path)} grows by "
            f"{_amount(rate * 3600)} an hour: the disk is full in {hours:.1f} h")
    advice = "Stop the stack before that (deploy/scarab down), or make room."
    return problem(text, advice) if free / rate < _SOON_S else note(text, advice)


def _bytes_per_s(directory: RunDirectory) -> float:
    """Since the stack was started, when its configuration was written."""
    try:
        age_s = time.time() - directory.config.stat().st_mtime
        size = sum(log.stat().st_size for log in directory.path.glob("trial*.mcap*"))
    except OSError:
        return 0.0
    return size / age_s if age_s > _LEAST_AGE_S else 0.0


def _amount(count: float) -> str:
    for unit, size in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
        if count >= size:
            return f"{count / size:.1f} {unit}"
    return f"{count:.0f} bytes"
