"""What `scarab emulator` and `scarab calibrate` take: files, and the faults that an emulator can have."""

from typing import Dict, Iterable, List

from .completion_values import Source, paths
from .tool_words import LATEST

_FILES = ("config", "plant", "output", "journal", "control")


class RobotValues:
    """`operands` are those already typed, of `emulator tell`."""

    def __init__(self, faults: Dict[str, str], operands: List[str]):
        self._faults = faults
        self._operands = operands

    def sources(self) -> Dict[str, Source]:
        files = {kind: lambda start: paths(start, True) for kind in _FILES}
        return {**files, "where": lambda start: [LATEST, *paths(start, True)], "words": lambda _: self._words()}

    def _words(self) -> Iterable[str]:
        """The fault comes first; of what follows the program's help tells."""
        return self._faults if len(self._operands) == 1 else ()
