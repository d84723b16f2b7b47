"""The directory of an experiment: what lies in it, and who writes there."""

import os
import shutil
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator

from ..failure import Failure, UsageError
from ..places import shown
from ..trial_lock import TrialLock
from .plan import PlannedTrial

_WRITTEN = ("plan.json", "journal.jsonl", "results.csv", "summary.json", "report.html", "config", "logs",
            "stacks", "*.svg", "*.png", "trial-*.mcap", "trial-*.mcap.active")


@dataclass(frozen=True)
class ExperimentDirectory:
    """Names of what lies in it."""

    path: Path

    @property
    def plan(self) -> Path:
        return self.path / "plan.json"

    @property
    def journal(self) -> Path:
        return self.path / "journal.jsonl"

    @property
    def results(self) -> Path:
        return self.path / "results.csv"

    @property
    def config(self) -> Path:
        return self.path / "config"

    @property
    def logs(self) -> Path:
        return self.path / "logs"

    @property
    def stacks(self) -> Path:
        """Run directories of the stacks that ran the trials."""
        return self.path / "stacks"

    def log_of(self, trial: PlannedTrial) -> Path:
        """Where a trial is recorded."""
        return self.path / f"trial-{trial.index}.mcap"

    @contextmanager
    def alone(self) -> Iterator[None]:
        """Makes it, and keeps every other launcher out. Failure where one is at work there."""
        _check_empty_or_ours(self)
        try:
            self.path.mkdir(parents=True, exist_ok=True)
            lock = TrialLock.try_take(self.path / ".lock")
        except OSError as error:
            raise Failure(f"cannot write to {shown(self.path)}: {error.strerror}") from None
        if lock is None:
            raise Failure(f"another launcher is at work in {shown(self.path)}: wait for it, or choose another "
                          "directory with --out")
        try:
            yield
        finally:
            lock.release()

    def clear(self) -> None:
        """Removes what an experiment leaves, and nothing else."""
        for pattern in _WRITTEN:
            for path in self.path.glob(pattern):
                if path.is_dir() and not path.is_symlink():
                    shutil.rmtree(path)
                else:
                    path.unlink()


def _check_empty_or_ours(directory: ExperimentDirectory) -> None:
    """UsageError where somebody keeps other things."""
    path = directory.path
    if path.exists() and not path.is_dir():
        raise UsageError(f"{shown(path)} is no directory; choose another one with --out")
    if not path.is_dir() or directory.plan.is_file():
        return
    others = sorted(set(os.listdir(path)) - {".lock"})
    if others:
        raise UsageError(f"{shown(path)} holds {others[0]}, but no plan.json: it is not the directory of an "
                         "experiment; choose another one with --out")
