"""The directory of one run: `runs/<date>-<n>/` with everything that run was and did."""

import datetime
import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import List

from .failure import Failure


@dataclass(frozen=True)
class RunDirectory:
    """Names of what lies in it."""

    path: Path

    def make_rooms(self) -> None:
        """The folders that a stack fills."""
        for room in (self.logs, self.config, self.pids, self.state):
            room.mkdir()

    @property
    def logs(self) -> Path:
        return self.path / "logs"

    @property
    def config(self) -> Path:
        return self.path / "config"

    @property
    def pids(self) -> Path:
        return self.path / "pids"

    @property
    def state(self) -> Path:
        return self.path / "state"

    @property
    def results(self) -> Path:
        return self.path / "results.csv"

    @property
    def device(self) -> Path:
        """Of emulated hardware: a link to its end of the wire."""
        return self.path / "device"

    @property
    def trial_lock(self) -> Path:
        return self.pids / "trial.lock"

    @property
    def events(self) -> Path:
        """What the keeper has done, a line of JSON each."""
        return self.logs / "events.jsonl"

    def log_of(self, process: str) -> Path:
        return self.logs / f"{process}.log"

    def pid_file_of(self, process: str) -> Path:
        return self.pids / f"{process}.json"


def create_run_directory(runs: Path) -> RunDirectory:
    """A new directory, the next number of today; `runs/latest` points to it."""
    today = datetime.date.today().isoformat()
    try:
        runs.mkdir(parents=True, exist_ok=True)
        path = _make_next(runs, today)
        _point_latest_to(runs, path)
    except OSError as error:
        raise Failure(f"cannot make a run directory in {runs}: {error.strerror}") from None
    return RunDirectory(path)


def run_directories(runs: Path) -> List[Path]:
    """All run directories, oldest first."""
    found = []
    for path in runs.glob("*-*-*-*") if runs.is_dir() else []:
        match = re.fullmatch(r"(\d{4}-\d{2}-\d{2})-(\d+)", path.name)
        if match and path.is_dir():
            found.append((match[1], int(match[2]), path))
    return [path for _, _, path in sorted(found)]


def _make_next(runs: Path, today: str) -> Path:
    numbers = [int(p.name.rsplit("-", 1)[1]) for p in run_directories(runs)
               if p.name.startswith(today + "-")]
    number = max(numbers, default=0) + 1
    while True:
        path = runs / f"{today}-{number}"
        try:
            path.mkdir()
            return path
        except FileExistsError:  # another launcher took the number in this moment
            number += 1


def _point_latest_to(runs: Path, path: Path) -> None:
    temporary = runs / f".latest-{path.name}"  # the name is ours alone
    temporary.unlink(missing_ok=True)
    temporary.symlink_to(path.name)
    os.replace(temporary, runs / "latest")
