"""What a keeper tells of its stack, to whoever runs trials on it."""

import json
from typing import Dict, List, Optional, Protocol

from .running_stack import RunningStack
from .signals import Signals

Event = Dict[str, object]
_POLL_S = 0.1


class KeeperEvents(Protocol):
    """The events of a keeper, wherever they are read."""

    ended: bool

    def events(self, signals: Signals, timeout_s: Optional[float] = None) -> List[Event]:
        """Waits for a signal, an event, or the time; then what the keeper has said so far."""


class EventTail:
    """Of a stack that is up: the end of its file of events, from now on."""

    def __init__(self, stack: RunningStack):
        self._keeper = stack.keeper
        self._file = open(stack.directory.events, "rb")
        self._file.seek(0, 2)
        self._rest = b""

    @property
    def ended(self) -> bool:
        return not self._keeper.alive()

    def events(self, signals: Signals, timeout_s: Optional[float] = None) -> List[Event]:
        signals.wait(_POLL_S if timeout_s is None else min(timeout_s, _POLL_S))
        *lines, self._rest = (self._rest + self._file.read()).split(b"\n")
        return [json.loads(line) for line in lines]


def event_line(event: Event) -> str:
    """What a person should read of an event; empty for the everyday ones."""
    name = event.get("service", "")
    kind = event["event"]
    if kind == "crashed":
        if event.get("waits"):
            return f"{name} {event['text']} in the middle of a trial, which is lost with it"
        return f"{name} {event['text']}; restart {event['restart']} follows in {event['wait_s']:g} s"
    if kind == "looping":
        return (f"{name} has crashed {event['crashes']} times in a row: deploy/scarab logs {name} "
                "says why")
    if kind == "lost":
        return f"{name} {event['text']}; it is not restarted"
    if kind == "killed":
        return f"{name} did not stop within {event['after_s']:g} s and was killed"
    if kind == "waiting":
        return f"waits: {event['text']}"
    if kind == "unstartable":
        return f"{name} cannot be restarted now: {event['text']}"
    return ""
