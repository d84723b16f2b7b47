"""Room for logs: the run directory can be written to, and its disk is not so full that the logger stops."""

import os
import shutil
import time
from pathlib import Path
from typing import List, Optional

import yaml

from ..failure import Failure
from ..log_files import log_files
from ..places import shown
from ..preflight import ask
from ..run_directory import RunDirectory
from ..stack import LOGGER
from .finding import Finding, note, ok, problem
from .recorded import RecordedStack
from .subject import Subject

_LEAST_FREE_BYTES = 500 * 1000 * 1000
_SOON_S = 3600.0
_TODAY_S = 24 * 3600.0
_MIB = 1 << 20
_ADVICE = "Remove old runs, or choose another place: --runs DIR"
_LEAST_AGE_S = 10.0  # of a log, before its growth says anything


def storage(subject: Subject) -> List[Finding]:
    runs = subject.places.runs
    place = next(p for p in (runs, *runs.parents) if p.exists())
    if not os.access(place, os.W_OK):
        return [problem(f"{shown(place)} cannot be written to, so that no run directory can be made",
                        "Give yourself the right to write there, or choose another place: --runs DIR")]
    free = shutil.disk_usage(place).free
    kept = kept_free(_configuration_of_next(subject))
    if free < kept:
        return [problem(f"only {_amount(free)} are free in {shown(place)}: the logger writes nothing with less than "
                        f"{_amount(kept)} (free_disk_mib of its configuration)", _ADVICE)]
    if free < kept + _LEAST_FREE_BYTES:
        until = f", of which the logger leaves {_amount(kept)} alone" if kept else ""
        return [problem(f"only {_amount(free)} are free in {shown(place)}{until}", _ADVICE)]
    filling = [f for f in (_filling(stack, free) for stack in subject.running) if f]
    return filling or [ok(f"{_amount(free)} are free in {shown(place)}")]


def kept_free(logger_configuration: str) -> int:
    """Bytes that a logger with this configuration leaves free on the disk; 0 without one."""
    read = yaml.safe_load(logger_configuration) or {}
    return int(read.get("free_disk_mib", 0)) * _MIB


def _configuration_of_next(subject: Subject) -> str:
    """Of the logger that a stack would have; empty where it would have none."""
    logger = subject.stack.service(LOGGER) if subject.stack else None
    try:
        return ask(subject.places, logger, "--dump-config") if logger else ""
    except Failure:  # not built, or of a file that it refuses: findings of their own
        return ""


def _filling(stack: RecordedStack, free: int) -> Optional[Finding]:
    """The logger of a stack that lasts stops some day: when, at its present rate."""
    rate = _bytes_per_s(stack.directory)
    if rate <= 0:
        return None
    left_s = (free - kept_free(_text(stack.directory.config / "logger.yaml"))) / rate
    if left_s > _TODAY_S:
        return None
    text = (f"{_amount(free)} are free, and the log of {shown(stack.directory.path)} grows by "
            f"{_amount(rate * 3600)} an hour: its logger stops in {max(0.0, left_s) / 3600:.1f} h")
    advice = "Stop the stack before that (deploy/scarab down), or make room."
    return problem(text, advice) if left_s < _SOON_S else note(text, advice)


def _text(file: Path) -> str:
    return file.read_text() if file.is_file() else ""


def _bytes_per_s(directory: RunDirectory) -> float:
    """Since the stack was started, when its configuration was written."""
    try:
        age_s = time.time() - directory.config.stat().st_mtime
        size = sum(log.stat().st_size for log in log_files(directory.path))
    except OSError:
        return 0.0
    return size / age_s if age_s > _LEAST_AGE_S else 0.0


def _amount(count: float) -> str:
    for unit, size in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
        if count >= size:
            return f"{count / size:.1f} {unit}"
    return f"{count:.0f} bytes"
