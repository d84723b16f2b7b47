"""What is examined: the stack file, the stacks that run, and what is seen of them on the bus."""

import argparse
import functools
import socket
from typing import Dict, Iterator, List, Optional, Sequence

from ..failure import ConfigError
from ..places import Places
from ..stack import Bus, Stack
from ..stack_file import read_stack
from ..stack_options import DEFAULT_PROFILE, changes_of
from ..status.processes import expected_processes
from .interfaces import LOOPBACK, flags_of, usable_interfaces
from .ports import DdsProcess, dds_processes
from .recorded import RecordedStack, recorded_stacks
from .survey import Seen, reports, survey

_UNTOLD_DOMAIN = 0  # the one that `up` takes
_MOST_INTERFACES = 8
_EVERYBODY = 1000  # participants; more than there are, so that the look takes all its time
_SEARCHED = range(0, 20)  # the domains that people choose


class Subject:
    """Everything is looked up when a check first asks for it, and then kept."""

    def __init__(self, options: argparse.Namespace, places: Places):
        """UsageError for a profile that is not there, or is not of the device that is named; a broken stack file is
        a finding."""
        self.options = options
        self.places = places
        self.host = socket.gethostname()
        self._long_looks: Dict[Bus, Seen] = {}
        self.stack: Optional[Stack] = None
        self.stack_fault: Optional[ConfigError] = None
        try:
            self.stack = read_stack(places.stack_file, options.profile or DEFAULT_PROFILE, places.root,
                                    changes_of(options))
        except ConfigError as fault:
            self.stack_fault = fault

    @functools.cached_property
    def recorded(self) -> List[RecordedStack]:
        return recorded_stacks(self.places.runs)

    @functools.cached_property
    def running(self) -> List[RecordedStack]:
        """Stacks of this source tree, those on --domain where it was given."""
        return [s for s in self.recorded
                if s.alive() and self.options.domain in (None, s.bus.domain)]

    @property
    def buses(self) -> List[Bus]:
        """Of the running stacks, else where one would come up."""
        return [s.bus for s in self.running] or [self._planned_bus()]

    @functools.cached_property
    def dds_processes(self) -> List[DdsProcess]:
        return dds_processes()

    def seen(self, bus: Bus) -> Seen:
        """What a participant sees that takes the place `bus`."""
        return self._surveys.get(bus) or Seen(bus)

    def seen_for_long(self, bus: Bus) -> Seen:
        """As seen(), but the look was not ended early by somebody who had not been counted on."""
        if len(self.seen(bus).participants) < self._participants_on(bus):
            return self.seen(bus)
        if bus not in self._long_looks:
            self._long_looks.update(survey(self.places, {bus: _EVERYBODY}, [bus]))
        return self._long_looks[bus]

    @functools.cached_property
    def reports(self) -> List[dict]:
        """What the services of all running stacks say of themselves."""
        return reports(self.places, self.running)

    def seen_beside(self, bus: Bus) -> List[Seen]:
        """The same from this machine's other interfaces."""
        return [seen for other, seen in self._surveys.items()
                if (other.domain, other.tag) == (bus.domain, bus.tag) and other != bus]

    def seen_elsewhere(self, domain: int) -> Sequence[dict]:
        """Participants seen on a domain that is no stack's of ours."""
        return [p for other, seen in self._surveys.items() if other.domain == domain
                for p in seen.participants]

    def search(self, bus: Bus) -> List[Seen]:
        """Looks at other domains by the same interface, in the hope to find who is missed."""
        places = [_moved(bus, domain, bus.interface) for domain in _SEARCHED if domain != bus.domain]
        return list(survey(self.places, {place: 1 for place in places}, []).values())

    @functools.cached_property
    def _surveys(self) -> Dict[Bus, Seen]:
        wanted = {bus: self._participants_on(bus) for bus in self._places_to_look()}
        return survey(self.places, wanted, [s.bus for s in self.running])

    def _places_to_look(self) -> Iterator[Bus]:
        """The stacks' own, the same by other interfaces, and where else DDS programs of this host are."""
        inhabited = {p.domain for p in self.dds_processes}
        for bus in self.buses:
            if bus.domain in inhabited or not _is_loopback(bus.interface):
                yield bus
            for interface in usable_interfaces()[:_MOST_INTERFACES] if inhabited else ():
                yield _moved(bus, bus.domain, interface)
        ours = {bus.domain for bus in self.buses}
        for process in self.dds_processes:
            if process.domain not in ours:
                for interface in sorted(process.interfaces) or [self.buses[0].interface]:
                    yield _moved(self.buses[0], process.domain, interface)

    def _participants_on(self, bus: Bus) -> int:
        """How many there must be at least, as the ports of this host tell, and the stack expects."""
        here = sum(p.participants for p in self.dds_processes
                   if p.domain == bus.domain and bus.interface in p.interfaces)
        expected = [len(expected_processes(s.expected)) for s in self.running if s.bus == bus]
        return max(1, here, *expected)

    def _planned_bus(self) -> Bus:
        domain = _UNTOLD_DOMAIN if self.options.domain is None else self.options.domain
        if self.stack is None:
            return Bus(domain, "lo", "")
        return Bus(domain, self.stack.interface, self.stack.tag, self.stack.peers)


def _moved(bus: Bus, domain: int, interface: str) -> Bus:
    same = (bus.domain, bus.interface) == (domain, interface)
    return bus if same else Bus(domain, interface, bus.tag)


def _is_loopback(interface: str) -> bool:
    return bool((flags_of(interface) or 0) & LOOPBACK)
