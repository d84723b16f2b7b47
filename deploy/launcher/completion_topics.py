"""The values of `scarab topic`: topics, their types and fields, of the system that the line speaks of."""

import csv
import json
import re
from typing import Dict, List

from .completion_values import Source
from .hearing import heard
from .places import Places

_PATIENCE_S = 0.3  # of somebody who waits for a Tab; who takes part in a domain knows the others in a tenth of that
_DECLARED = re.compile(r'Topic<(\w+?)_(\w+)> \w+\{"([\w/]+)"')


class TopicValues:
    """Of one line, which has named `topic`, or not yet; `bus` are the options that say where to look."""

    def __init__(self, places: Places, bus: List[str], topic: str):
        self._places = places
        self._bus = bus
        self._topic = topic

    def sources(self) -> Dict[str, Source]:
        """By the kind of the value."""
        return {"topic": lambda _: self._types(), "type": lambda _: set(self._types().values()),
                "field": lambda _: self._fields()}

    def _types(self) -> Dict[str, str]:
        """Of each topic that somebody writes or reads; of the project's own where nobody answers in time."""
        try:
            seen = json.loads(self._heard("list", "--json", "--timeout", f"{_PATIENCE_S:g}"))
            found = {topic["topic"]: topic["type"] for topic in seen}
        except (ValueError, KeyError, TypeError):
            found = {}
        return found or self._declared()

    def _declared(self) -> Dict[str, str]:
        text = (self._places.root / "common" / "bus" / "topics.hpp").read_text()
        return {topic: f"{module}::{name}" for module, name, topic in _DECLARED.findall(text)}

    def _fields(self) -> List[str]:
        """The heading of the topic's table, which comes before the first sample."""
        heading = self._heard("echo", self._topic, "--csv", first_line=True) if self._topic else ""
        return next(csv.reader([heading]), [])

    def _heard(self, *words: str, first_line: bool = False) -> str:
        command = [str(self._places.program("scarab-topic")), *words, *self._bus]
        return heard(command, _PATIENCE_S, first_line)
