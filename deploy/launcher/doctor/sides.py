"""Two sides that do not meet: on different domains, different interfaces, or apart by a tag."""

from typing import List, Optional, Sequence, Set

from ..stack import Bus
from .finding import Finding, note, ok, problem
from .missed import missed
from .ports import DdsProcess
from .sockets import unix_socket_inode
from .subject import Subject
from .survey import speaks_scarab, who


def sides(subject: Subject) -> List[Finding]:
    found = [finding for bus in subject.buses for finding in _beside(subject, bus)]
    if not found and not subject.running:
        return [ok("no stack runs that somebody could miss")]
    return found or [ok("nobody who belongs to the stack is on another domain or interface")]


def _beside(subject: Subject, bus: Bus) -> List[Finding]:
    """Everybody who stands apart from `bus`."""
    if not subject.running and not _inhabited(subject, bus):
        return []
    local = [_local(subject, bus, process) for process in subject.dds_processes]
    return [f for f in (*local, *_other_hosts(subject, bus), *missed(subject, bus)) if f]


def _inhabited(subject: Subject, bus: Bus) -> bool:
    return any(p.domain == bus.domain for p in subject.dds_processes)


def _local(subject: Subject, bus: Bus, process: DdsProcess) -> Optional[Finding]:
    if process.domain != bus.domain:
        return _on_another_domain(subject, bus, process)
    if process.interfaces and bus.interface not in process.interfaces:
        return problem(
            f"{process.program} is on DDS domain {bus.domain} by interface "
            f"{' and '.join(sorted(process.interfaces))}, the stack by {bus.interface}: they do "
            "not meet",
            f"Start it with --interface {bus.interface}, or set bus.interface in the stack file.")
    return _apart_by_tag(subject, bus, process)


def _on_another_domain(subject: Subject, bus: Bus, process: DdsProcess) -> Optional[Finding]:
    if unix_socket_inode(f"scarab-domain-{process.domain}") is not None:
        return None  # there is a stack of its own
    what = (f"{process.program} is on DDS domain {process.domain}, the stack on {bus.domain}: they "
            "do not meet")
    own = [seen for seen in subject.seen_elsewhere(process.domain)
           if seen["pid"] in (0, process.program.pid)]
    if any(map(speaks_scarab, own)):
        return problem(what + ", though it has topics of the stack (scarab/...)",
                       f"Start it with --domain {bus.domain} (Fast DDS and ROS: "
                       f"ROS_DOMAIN_ID={bus.domain}).")
    return note(what, f"If it belongs to the stack, start it on domain {bus.domain}.")


def _apart_by_tag(subject: Subject, bus: Bus, process: DdsProcess) -> Optional[Finding]:
    if process.program.pid == 0 or not subject.seen(bus).participants:
        return None  # another user's, or nothing can be seen at all
    if any(process.program.pid in _pids_here(subject, look(bus).participants)
           for look in (subject.seen, subject.seen_for_long)):
        return None
    tag = f"'{bus.tag}'" if bus.tag else "none"
    return note(f"{process.program} is on DDS domain {bus.domain} and interface {bus.interface}, "
                "but does not answer: it has another discovery tag, or a configuration of its own",
                f"If it belongs to the stack, give it the stack's tag ({tag}) and see its "
                "CYCLONEDDS_URI.")


def _pids_here(subject: Subject, participants: Sequence[dict]) -> Set[int]:
    return {p["pid"] for p in participants if p["host"] in ("", subject.host)}


def _other_hosts(subject: Subject, bus: Bus) -> List[Finding]:
    here = {(p["host"], p["pid"]) for p in subject.seen(bus).participants}
    found = []
    for seen in subject.seen_beside(bus):
        for other in seen.participants:
            remote = other["host"] not in ("", subject.host)
            if remote and speaks_scarab(other) and (other["host"], other["pid"]) not in here:
                found.append(problem(
                    f"{who(other)} is seen by interface {seen.bus.interface}, the stack is on "
                    f"{bus.interface}: they do not meet",
                    f"Start the stack with --interface {seen.bus.interface}, or set bus.interface in "
                    "the stack file."))
    return found
