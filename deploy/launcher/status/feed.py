"""What the services of a stack say: the documents of scarab-status, one after the other."""

import json
import os
import subprocess
from typing import Optional

from ..places import Places
from ..running_stack import RunningStack
from ..spawn import spawn

_LOOK_S = 1.0
_PATIENCE_S = 3.0  # with who says nothing


class Feed:
    """A scarab-status that looks on at one stack; to be closed."""

    def __init__(self, places: Places, stack: RunningStack, period_s: Optional[float]):
        """Without a period there is one document only."""
        self.stack = stack
        how = ["--watch", "--period", f"{period_s:g}"] if period_s else ["--look", f"{_LOOK_S:g}"]
        self._process = spawn(
            [places.program("scarab-status"), *stack.bus.arguments(), "--json", *how,
             "--wait", stack.expected, "--timeout", f"{_PATIENCE_S:g}"],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        os.set_blocking(self._process.stdout.fileno(), False)
        self._buffer = b""
        self.document: Optional[dict] = None  # the newest
        self.fresh = False  # since take()
        self.ended = False

    def fileno(self) -> int:
        return self._process.stdout.fileno()

    def read(self) -> None:
        """To be called when there is something to read."""
        try:
            while not self.ended:
                block = os.read(self.fileno(), 65536)
                self._buffer += block
                self.ended = not block
        except BlockingIOError:
            pass
        *lines, self._buffer = self._buffer.split(b"\n")
        for line in lines:
            self.document = json.loads(line)
            self.fresh = True

    def take(self) -> Optional[dict]:
        self.fresh = False
        return self.document

    def close(self) -> None:
        self._process.stdout.close()
        if self._process.poll() is None:
            self._process.terminate()
        self._process.wait()
