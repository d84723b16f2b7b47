"""Services that a running stack expects, and that are not on its domain: where are they?"""

from typing import Dict, List

from ..stack import Bus
from ..status.processes import ProcessView, expected_processes
from ..status.waits import join
from .finding import Finding, problem
from .ports import multicast_ports
from .subject import Subject
from .survey import who


def missed(subject: Subject, bus: Bus) -> List[Finding]:
    """Looked for on other domains of the network. Empty where everybody is there."""
    expected = next((s.expected for s in subject.running if s.bus == bus and s.ready), "")
    absent = ["%s/%d" % ProcessView(name).service for name in expected_processes(expected)]
    for look in (subject.seen, subject.seen_for_long):
        there = {p["service"] for p in look(bus).participants} if absent else ()
        absent = [name for name in absent if name not in there]
    if not absent or subject.seen(bus).fault:
        return []
    elsewhere = _found(subject, bus, absent)
    nowhere = [name for name in absent if name not in elsewhere]
    return [*elsewhere.values(), *([_nowhere(bus, nowhere)] if nowhere else [])]


def _found(subject: Subject, bus: Bus, absent: List[str]) -> Dict[str, Finding]:
    """By name."""
    found = {}
    for seen in subject.search(bus):
        for participant in seen.participants:
            if participant["service"] in absent:
                found[participant["service"]] = problem(
                    f"{who(participant)} is on DDS domain {seen.bus.domain}, the stack that expects it "
                    f"on {bus.domain}: they do not meet",
                    "Start both sides with the same --domain.")
    return found


def _nowhere(bus: Bus, names: List[str]) -> Finding:
    low, high = multicast_ports(bus.domain)[0], multicast_ports(bus.domain + 1)[0] - 1
    are = "are" if len(names) > 1 else "is"
    return problem(
        f"{join(names)} {are} expected, but {are} not seen on DDS domain {bus.domain} by interface "
        f"{bus.interface}",
        f"On this host: deploy/scarab logs {names[0].split('/')[0]}. On another one: start the other "
        f"half there (deploy/scarab up --profile ...), on the network of {bus.interface}, and let UDP "
        f"ports {low} to {high} pass the firewalls of both.")
