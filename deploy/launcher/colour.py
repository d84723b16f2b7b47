"""Colours for a person: on a terminal only, and never with NO_COLOR (see no-color.org)."""

import os
from typing import TextIO

_CODES = {"red": "31", "green": "32", "yellow": "33", "bold": "1", "faint": "2"}


class Colour:
    """Paints text for one stream, or leaves it alone."""

    def __init__(self, stream: TextIO):
        self._on = stream.isatty() and not os.environ.get("NO_COLOR")

    def paint(self, text: str, name: str) -> str:
        return f"\033[{_CODES[name]}m{text}\033[0m" if self._on else text
