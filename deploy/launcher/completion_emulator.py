"""What can be said to an emulator: where it is, and which fault it is to have."""

from typing import Dict, Iterable, List

from .completion_values import Source, paths
from .tool_words import LATEST


class EmulatorValues:
    """Of a line `emulator tell`: `operands` are those already typed."""

    def __init__(self, faults: Dict[str, str], operands: List[str]):
        self._faults = faults
        self._operands = operands

    def sources(self) -> Dict[str, Source]:
        return {"where": lambda start: [LATEST, *paths(start, True)], "words": lambda _: self._words()}

    def _words(self) -> Iterable[str]:
        """The fault comes first; of what follows the program's help tells."""
        return self._faults if len(self._operands) == 1 else ()
