"""What a program says within the time that a person waits for a Tab."""

import os
import select
import subprocess
import time
from typing import Sequence

from .spawn import clean_environment

_END_PATIENCE_S = 0.5


def heard(command: Sequence[str], patience_s: float, first_line: bool = False) -> str:
    """Its standard output, up to the first line's end where no more is wanted. Empty where it does not come to that,
    or to its own end, in time."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, env=clean_environment())
    try:
        return _read(process.stdout.fileno(), time.monotonic() + patience_s, first_line)
    finally:
        process.stdout.close()
        _end(process)


def _read(source: int, deadline: float, first_line: bool) -> str:
    said = b""
    while True:
        if not select.select([source], [], [], max(0.0, deadline - time.monotonic()))[0]:
            return ""
        part = os.read(source, 65536)
        said += part
        if first_line and b"\n" in said:
            return said.partition(b"\n")[0].decode(errors="replace")
        if not part:
            return "" if first_line else said.decode(errors="replace")


def _end(process: subprocess.Popen) -> None:
    """Politely first: a participant that leaves without a word is missed for seconds."""
    process.terminate()
    try:
        process.wait(_END_PATIENCE_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
