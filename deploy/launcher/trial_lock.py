"""One series of trials at a time on a stack, known to whoever keeps the stack running."""

import fcntl
import os
import time
import uuid
from pathlib import Path
from typing import Optional

_LOOK_PATIENCE_S = 0.5  # far longer than series_that_runs() holds the lock
_POLL_S = 0.01


class TrialLock:
    """A file lock: it ends with the process that holds it, however that ends. The file names the series of
    trials that took it last."""

    def __init__(self, descriptor: int):
        self._descriptor = descriptor

    @staticmethod
    def try_take(file: Path) -> Optional["TrialLock"]:
        """The lock, or None while somebody else runs trials."""
        descriptor = os.open(file, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
        patience_ends = time.monotonic() + _LOOK_PATIENCE_S
        while not _lock(descriptor, fcntl.LOCK_EX):
            if time.monotonic() > patience_ends:
                os.close(descriptor)
                return None
            time.sleep(_POLL_S)  # it may only be a look
        os.pwrite(descriptor, uuid.uuid4().hex.encode(), 0)
        return TrialLock(descriptor)

    def release(self) -> None:
        os.close(self._descriptor)


def series_that_runs(file: Path) -> str:
    """Names the series of trials that runs on the stack; empty where none does."""
    try:
        descriptor = os.open(file, os.O_RDONLY | os.O_CLOEXEC)
    except OSError:
        return ""
    try:
        return "" if _lock(descriptor, fcntl.LOCK_SH) else os.pread(descriptor, 64, 0).decode()
    finally:
        os.close(descriptor)


def _lock(descriptor: int, kind: int) -> bool:
    try:
        fcntl.flock(descriptor, kind | fcntl.LOCK_NB)
        return True
    except BlockingIOError:
        return False
