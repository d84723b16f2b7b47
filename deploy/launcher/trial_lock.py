"""One series of trials at a time on a stack, known to whoever keeps the stack running."""

import fcntl
import os
from pathlib import Path
from typing import Optional


class TrialLock:
    """A file lock: it ends with the process that holds it, however that ends."""

    def __init__(self, descriptor: int):
        self._descriptor = descriptor

    @staticmethod
    def try_take(file: Path) -> Optional["TrialLock"]:
        """The lock, or None while somebody else runs trials."""
        descriptor = os.open(file, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(descriptor)
            return None
        return TrialLock(descriptor)

    def release(self) -> None:
        os.close(self._descriptor)


def trial_is_running(file: Path) -> bool:
    lock = TrialLock.try_take(file)
    if lock is None:
        return True
    lock.release()
    return False
