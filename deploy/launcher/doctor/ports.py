"""The UDP ports of DDS: which process is on which domain, and by which interface (RTPS 2.5, 9.6.2)."""

from dataclasses import dataclass, field
from typing import Dict, List, Set, Tuple

from ..program import Program
from .interfaces import names_by_address
from .sockets import UdpSocket, owners, udp_sockets

DOMAINS = range(0, 231)
PARTICIPANT_INDICES = range(0, 64)  # of the project's configuration; the standard has 120


def multicast_ports(domain: int) -> Tuple[int, int]:
    """Discovery and data; shared by all participants of the domain on a host."""
    base = 7400 + 250 * domain
    return base, base + 1


def unicast_ports(domain: int, index: int) -> Tuple[int, int]:
    """Discovery and data of one participant."""
    base = 7410 + 250 * domain + 2 * index
    return base, base + 1


@dataclass
class DdsProcess:
    """A process of this host with participants on one domain."""

    program: Program
    domain: int
    participants: int = 0
    interfaces: Set[str] = field(default_factory=set)  # by name; empty: it does not show


def dds_processes() -> List[DdsProcess]:
    """Every vendor's, by domain; a process on two domains is there twice."""
    sockets = udp_sockets()
    of_program: Dict[Program, List[UdpSocket]] = {}
    holders = owners(s.inode for s in sockets)
    for one in sockets:
        of_program.setdefault(holders[one.inode], []).append(one)
    names = names_by_address()
    found = [process for program, held in of_program.items()
             for process in _participations(program, held, names)]
    return sorted(found, key=lambda p: (p.domain, p.program.pid))


def _participations(program: Program, held: List[UdpSocket],
                    names: Dict[str, str]) -> List[DdsProcess]:
    """A participant shares the domain's multicast port, and has two unicast ports of its own."""
    ports = {s.port for s in held}
    sending = {names[s.address] for s in held if s.address in names}  # Cyclone binds what it sends by
    found = []
    for domain in DOMAINS:
        if multicast_ports(domain)[0] not in ports:
            continue
        own = [i for i in PARTICIPANT_INDICES if ports.issuperset(unicast_ports(domain, i))]
        found.append(DdsProcess(program, domain, len(own), sending))
    return found
