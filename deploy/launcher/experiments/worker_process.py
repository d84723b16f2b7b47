"""A program that reads a trial a line and answers with a result a line."""

import os
import signal
import subprocess
from contextlib import suppress
from pathlib import Path
from typing import List, Optional, Sequence, Union

from ..service_child import how_it_ended, last_lines
from ..spawn import spawn
from .seat import Fault


class WorkerProcess:
    """Its end shows at its output, which is the one thing to wait for. What it says besides goes to a log
    file."""

    def __init__(self, command: Sequence[Union[str, Path]], log_file: Path):
        """Fault where it cannot be started, such as while it is being rebuilt."""
        try:
            with open(log_file, "ab") as log:
                self._process = spawn(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log)
        except OSError as error:
            raise Fault(f"{Path(command[0]).name} cannot be started: {error.strerror}") from None
        self._log_file = log_file
        self._buffer = b""
        self._lines: List[str] = []
        self.ended = False
        os.set_blocking(self._process.stdout.fileno(), False)

    @property
    def descriptor(self) -> int:
        """Readable when it has something to say, or has ended."""
        return self._process.stdout.fileno()

    def give(self, line: str) -> None:
        with suppress(BrokenPipeError):  # its end shows elsewhere
            self._process.stdin.write(line.encode() + b"\n")
            self._process.stdin.flush()

    def take_line(self) -> Optional[str]:
        """The next whole line of its output, or None as yet."""
        with suppress(BlockingIOError):
            while not self.ended:
                block = os.read(self.descriptor, 65536)
                self._buffer += block
                self.ended = not block
        *lines, self._buffer = self._buffer.split(b"\n")
        self._lines += [line.decode(errors="replace") for line in lines]
        return self._lines.pop(0) if self._lines else None

    def finish(self, patience_s: float) -> int:
        """Tells it that no more trials come, and waits for its end. Its return code, as of subprocess."""
        with suppress(BrokenPipeError):
            self._process.stdin.close()
        if not self._ends_within(patience_s):
            return self.end(patience_s)
        return self._closed()

    def ask_to_end(self) -> None:
        """At once, whatever it is at; to be followed by end()."""
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGTERM)

    def end(self, patience_s: float) -> int:
        self.ask_to_end()
        if not self._ends_within(patience_s):
            self._process.kill()
            self._process.wait()
        return self._closed()

    def how_it_ended(self, patience_s: float) -> str:
        """In words, with the last line of its log. Of one whose output has ended."""
        code = self.end(patience_s) if not self._ends_within(patience_s) else self._process.returncode
        said = last_lines(self._log_file, 1)
        return how_it_ended(code) + (f" ({said[0]})" if said else "")

    def _ends_within(self, patience_s: float) -> bool:
        try:
            self._process.wait(patience_s)
        except subprocess.TimeoutExpired:
            return False
        return True

    def _closed(self) -> int:
        self.ended = True
        with suppress(BrokenPipeError):  # a line that it did not read
            self._process.stdin.close()
        self._process.stdout.close()
        return self._process.returncode
