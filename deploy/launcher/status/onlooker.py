"""Looks at all running stacks of this source tree, once or again and again."""

import time
from typing import Dict, List, Optional, Sequence, Tuple

from ..places import Places
from ..running_stack import RunningStack, running_stacks
from ..signals import Signals
from .feed import Feed
from .picture import Picture, take_picture
from .processes import CpuMeter

_PATIENCE_S = 10.0
Key = Tuple[int, int]


class Onlooker:
    """A context: its feeds end with it."""

    def __init__(self, places: Places, domain: Optional[int], period_s: Optional[float]):
        """Without a period there is one look only."""
        self._places = places
        self._domain = domain
        self._period_s = period_s
        self._feeds: Dict[Key, Feed] = {}
        self._meters: Dict[Key, CpuMeter] = {}

    def __enter__(self) -> "Onlooker":
        return self

    def __exit__(self, *_: object) -> None:
        for feed in self._feeds.values():
            feed.close()

    def look(self, signals: Signals) -> List[Picture]:
        """Waits for the services' next word, at most a little longer than the period."""
        self._follow(self._stacks())
        self._await_feeds(signals)
        return [self._picture(stack) for stack in self._stacks()]

    def troubles(self, pictures: Sequence[Picture]) -> List[str]:
        """Of all stacks together; empty where all is well."""
        if not pictures:
            where = "" if self._domain is None else f" on DDS domain {self._domain}"
            return [f"no stack is running{where}"]
        several = len(pictures) > 1
        return [(f"DDS domain {p.stack.bus.domain}: " if several else "") + text
                for p in pictures for text in p.troubles()]

    def _stacks(self) -> List[RunningStack]:
        return [s for s in running_stacks(self._places.runs)
                if self._domain in (None, s.bus.domain)]

    def _follow(self, stacks: Sequence[RunningStack]) -> None:
        """One feed a stack that lives."""
        living = {_key(stack): stack for stack in stacks}
        for key in [k for k, feed in self._feeds.items() if k not in living or feed.ended]:
            self._feeds.pop(key).close()
        for key, stack in living.items():
            if key not in self._feeds:
                self._feeds[key] = Feed(self._places, stack, self._period_s)
                self._meters.setdefault(key, CpuMeter())
                take_picture(stack, self._meters[key], None)  # where the processor's shares begin

    def _await_feeds(self, signals: Signals) -> None:
        period_s = self._period_s or 0.0
        deadline = time.monotonic() + (period_s + _PATIENCE_S if self._feeds else period_s)
        while not signals.stop_requested:
            waiting = [f for f in self._feeds.values() if not f.fresh and not f.ended]
            left_s = deadline - time.monotonic()
            if left_s <= 0 or (self._feeds and not waiting):
                return
            readable = signals.wait(left_s, [f.fileno() for f in waiting])
            for feed in waiting:
                if feed.fileno() in readable:
                    feed.read()

    def _picture(self, stack: RunningStack) -> Picture:
        key = _key(stack)
        feed = self._feeds.get(key)
        return take_picture(stack, self._meters.setdefault(key, CpuMeter()),
                            feed.take() if feed else None)


def _key(stack: RunningStack) -> Key:
    return stack.keeper.pid, stack.keeper.start_ticks
