"""Whether the services of a stack are ready, asked of scarab-status, which waits for them."""

import os
import subprocess
import tempfile
from contextlib import suppress
from typing import List, Sequence

from .signals import Signals
from .spawn import spawn

_TERM_PATIENCE_S = 5.0
_PROGRESS = "waiting: "  # in front of what it says meanwhile


class ReadinessQuestion:
    """A context: the program ends with it."""

    def __init__(self, command: Sequence[str]):
        """The command ends with 0 when all are ready."""
        self._table = tempfile.TemporaryFile()
        self._process = spawn(command, stdout=self._table, stderr=subprocess.PIPE)
        self._complaints = self._process.stderr.fileno()
        os.set_blocking(self._complaints, False)
        self._buffer = b""
        self._lines: List[str] = []

    def __enter__(self) -> "ReadinessQuestion":
        return self

    def __exit__(self, *_: object) -> None:
        if self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(_TERM_PATIENCE_S)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
        self._process.stderr.close()
        self._table.close()

    @property
    def is_open(self) -> bool:
        return self._process.poll() is None

    @property
    def ready(self) -> bool:
        """Once it is not open any more."""
        return self._process.returncode == 0

    def wait(self, signals: Signals, timeout_s: float) -> List[str]:
        """For a signal, or the time, or news; what has become known of those that are waited for."""
        signals.wait(timeout_s, [self._complaints])
        return [line.partition(_PROGRESS)[2] for line in self._new_lines() if _PROGRESS in line]

    def answer(self) -> str:
        """The services as they were in the end, and what was wrong with them."""
        self._new_lines()
        self._table.seek(0)
        table = self._table.read().decode(errors="replace").strip()
        return "\n".join(filter(None, [table, *(line for line in self._lines if _PROGRESS not in line)]))

    def _new_lines(self) -> List[str]:
        with suppress(BlockingIOError):
            while block := os.read(self._complaints, 65536):
                self._buffer += block
        *lines, self._buffer = self._buffer.split(b"\n")
        new = [line.decode(errors="replace") for line in lines]
        self._lines += new
        return new
