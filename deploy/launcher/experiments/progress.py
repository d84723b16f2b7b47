"""How far an experiment is: one line of a terminal, or a line of a file now and then."""

import os
import time
from typing import Callable, Optional, Sequence, TextIO

from .estimate import Estimate, duration
from .results import Result

_BAR, _SHORTEST_BAR = 24, 4
_TERMINAL_EVERY_S = 0.2
_FILE_EVERY_S = 10.0
_COLUMNS = 80  # of a terminal that does not know


class Progress:
    """Of `total` trials, some of which have been done before."""

    def __init__(self, name: str, total: int, done_before: Sequence[Result], estimate: Estimate,
                 stream: TextIO, clock: Callable[[], float] = time.monotonic):
        self.total = total
        self.done = len(done_before)
        self._name = name
        self._successes = sum(result.success for result in done_before)
        self._estimate = estimate
        self._stream = stream
        self._terminal = stream.isatty()
        self._clock = clock
        self._shown_at: Optional[float] = None

    def add(self, result: Result) -> None:
        """A trial has been done."""
        self.done += 1
        self._successes += result.success

    def show(self) -> None:
        """If the last time is long enough ago."""
        every_s = _TERMINAL_EVERY_S if self._terminal else _FILE_EVERY_S
        if self._shown_at is not None and self._clock() - self._shown_at < every_s:
            return
        self._write()

    def finish(self) -> None:
        """The last state, which stays."""
        self._write()
        if self._terminal:
            print(file=self._stream, flush=True)

    def text(self, width: int = 1000) -> str:
        """The bar is shorter where the whole would be wider than that."""
        words = self._words()
        bar = max(_SHORTEST_BAR, min(_BAR, width - len(f"{self._name} [] {words}")))
        filled = bar * self.done // self.total
        return f"{self._name} [{'=' * filled:{bar}}] {words}"[:width]

    def _words(self) -> str:
        parts = [f"{self.done}/{self.total}", f"{self._successes} succeeded"]
        if self._estimate.speed is not None:
            parts.append(f"{self._estimate.speed:.0f} x real time")
        left_s = self._estimate.left_s()
        if self.done < self.total:
            parts.append(f"{duration(left_s)} left" if left_s is not None else "starting")
        return ", ".join(parts)

    def _write(self) -> None:
        self._shown_at = self._clock()
        if self._terminal:
            print(f"\r\033[K{self.text(_columns(self._stream) - 1)}", end="", file=self._stream, flush=True)
        else:
            print(self.text(), file=self._stream, flush=True)


def _columns(terminal: TextIO) -> int:
    try:
        return os.get_terminal_size(terminal.fileno()).columns or _COLUMNS
    except OSError:
        return _COLUMNS
