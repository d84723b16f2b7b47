"""The values of `scarab topic`: topics, types and fields, of the system that the line speaks of."""

import json
import re
from typing import Dict, List, Set

from .completion_values import Source
from .hearing import heard
from .places import Places

_LOOK_S = 0.3  # who takes part in a domain knows the others in a tenth of that
_PATIENCE_S = 0.5  # of somebody who waits for a Tab
_DECLARED = re.compile(r'Topic<(\w+?)_(\w+)> \w+\{"([\w/]+)"')


class TopicValues:
    """Of one line, which has named `topic`, or not yet; `bus` are the options that say where to look. Where nobody
    answers in time it is the project's own that are offered."""

    def __init__(self, places: Places, bus: List[str], topic: str):
        self._places = places
        self._bus = bus
        self._topic = topic

    def sources(self) -> Dict[str, Source]:
        """By the kind of the value."""
        return {"topic": lambda _: self._topics(), "type": lambda _: self._types(),
                "name": lambda _: self._types(), "field": lambda _: self._fields()}

    def _topics(self) -> List[str]:
        return self._heard("list", "--names").splitlines() or list(self._declared())

    def _types(self) -> Set[str]:
        try:
            seen = json.loads(self._heard("list", "--json", "--timeout", f"{_LOOK_S:g}"))
            found = {topic["type"] for topic in seen}
        except (ValueError, KeyError, TypeError):
            found = set()
        return found | set(self._declared().values())

    def _fields(self) -> List[str]:
        if not self._topic:
            return []
        type_name = self._declared().get(self._topic)
        of_whom = ["--name", type_name] if type_name else [self._topic, "--timeout", f"{_LOOK_S:g}"]
        return self._heard("fields", "--names", *of_whom).splitlines()

    def _declared(self) -> Dict[str, str]:
        """Topic -> type."""
        text = (self._places.root / "common" / "bus" / "topics.hpp").read_text()
        return {topic: f"{module}::{name}" for module, name, topic in _DECLARED.findall(text)}

    def _heard(self, *words: str) -> str:
        return heard([str(self._places.program("scarab-topic")), *words, *self._bus], _PATIENCE_S)
