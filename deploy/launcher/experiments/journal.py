"""journal.jsonl: result lines as they come, so that nothing is lost however the launcher ends."""

import os
import time
from pathlib import Path
from typing import Dict, Iterable, List, Optional

from ..failure import Failure
from .plan import PlannedTrial
from .results import ForeignLine, Result, read_result

_SYNC_EVERY_S = 1.0


class Journal:
    """Appends. A line is with the kernel at once, and on the disk a second later at most."""

    def __init__(self, file: Path):
        _cut_torn_line(file)
        self._descriptor = os.open(file, os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_CLOEXEC, 0o644)
        self._unsynced_since: Optional[float] = None

    def add(self, line: str) -> None:
        rest = line.encode() + b"\n"
        while rest:
            rest = rest[os.write(self._descriptor, rest):]
        if self._unsynced_since is None:
            self._unsynced_since = time.monotonic()
        self.sync_if_due()

    def sync_if_due(self) -> None:
        if self._unsynced_since is not None and time.monotonic() - self._unsynced_since >= _SYNC_EVERY_S:
            self.sync()

    def sync(self) -> None:
        os.fsync(self._descriptor)
        self._unsynced_since = None

    def close(self) -> None:
        self.sync()
        os.close(self._descriptor)


def read_journal(file: Path, trials: Iterable[PlannedTrial]) -> List[Result]:
    """What has been done of these trials, in the order of the file. A line that was cut off while it was
    written is none. Failure for a line that is not of them."""
    planned = {trial.index: trial for trial in trials}
    found: Dict[int, Result] = {}
    for number, line in enumerate(_whole_lines(file), start=1):
        try:
            result = read_result(line, planned)
        except ForeignLine as error:
            raise Failure(f"{file}:{number}: {error}. Start over with --fresh") from None
        found.setdefault(result.trial.index, result)
    return list(found.values())


def _whole_lines(file: Path) -> List[str]:
    try:
        return file.read_bytes().decode(errors="replace").split("\n")[:-1]
    except FileNotFoundError:
        return []


def _cut_torn_line(file: Path) -> None:
    """What a launcher that was killed in the middle of a line has left of it."""
    try:
        with open(file, "r+b") as journal:
            text = journal.read()
            journal.truncate(text.rfind(b"\n") + 1)
    except FileNotFoundError:
        pass
