"""The values of `scarab log`: logs, the topics in one of them, and their fields."""

import csv
import json
from typing import Dict, Iterable, List

from .completion_values import Source, paths
from .hearing import heard
from .log_files import is_log
from .places import Places
from .tool_words import LATEST, logs_meant

_PATIENCE_S = 2.0


class LogValues:
    """Of one line, which has named `log` and `topic`, or not yet."""

    def __init__(self, places: Places, log: str, topic: str):
        self._places = places
        self._log = log
        self._topic = topic

    def sources(self) -> Dict[str, Source]:
        """By the kind of the value."""
        return {"log": self._logs, "topic": lambda _: self._listed("topics", "topic"),
                "except": lambda _: self._listed("topics", "topic"), "trial": lambda _: self._listed("trials", "trial"),
                "field": lambda _: self._fields(), "ignore": lambda _: self._fields()}

    def _logs(self, start: str) -> Iterable[str]:
        """Files, the folders on the way to them, and the word for the newest run's."""
        return [LATEST, *(path for path in paths(start, True) if path.endswith("/") or is_log(path))]

    def _listed(self, what: str, key: str) -> List[str]:
        """Of what the log holds."""
        try:
            return [str(each[key]) for each in json.loads(self._heard("info", "--json"))[what]]
        except (ValueError, KeyError, TypeError):
            return []

    def _fields(self) -> List[str]:
        """The heading of the topic's table."""
        if not self._topic:
            return []
        heading = self._heard("export", "--topic", self._topic, "--format", "csv", first_line=True)
        return next(csv.reader([heading]), [])

    def _heard(self, command: str, *options: str, first_line: bool = False) -> str:
        if not self._log:
            return ""
        logs = map(str, logs_meant(self._log, self._places) or [self._log])
        return heard([str(self._places.program("scarab-log")), command, *logs, *options], _PATIENCE_S, first_line)
