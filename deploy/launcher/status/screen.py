"""A block of lines that is drawn over and over at the same place of a terminal."""

import re
import shutil
from typing import List, TextIO

_HIDE, _SHOW = "\033[?25l", "\033[?25h"
_NO_WRAP, _WRAP = "\033[?7l", "\033[?7h"
_TO_LINE_END, _TO_SCREEN_END = "\033[K", "\033[J"
_PAINT = re.compile(r"(\033\[\d+m)")


class Screen:
    """On a terminal each block replaces the last one, line by line, so that nothing flickers; into a
    file or pipe blocks follow each other. A context: the terminal is left as it was."""

    def __init__(self, stream: TextIO):
        self._stream = stream
        self._terminal = stream.isatty()
        self._drawn = 0

    def __enter__(self) -> "Screen":
        if self._terminal:
            self._stream.write(_HIDE)
        return self

    def __exit__(self, *_: object) -> None:
        if self._terminal:
            self._stream.write(_SHOW)
            self._stream.flush()

    def draw(self, lines: List[str]) -> None:
        if not self._terminal:
            self._stream.write("\n".join([*lines, "", ""]))
        else:
            size = shutil.get_terminal_size()
            fitting = lines[:max(1, size.lines - 1)]
            up = f"\033[{self._drawn}F" if self._drawn else ""
            body = "".join(f"{clipped(line, size.columns)}{_TO_LINE_END}\n" for line in fitting)
            self._stream.write(f"{up}{_NO_WRAP}{body}{_TO_SCREEN_END}{_WRAP}")
            self._drawn = len(fitting)
        self._stream.flush()


def clipped(line: str, width: int) -> str:
    """The first `width` characters that show; colours do not count, and end where it is cut."""
    out, left = [], width
    for part in _PAINT.split(line):
        if _PAINT.fullmatch(part):
            out.append(part)
        else:
            out.append(part[:left])
            left -= len(out[-1])
    return "".join(out)
