"""The DDS domain: whose it is already, and whether its ports and participant indices are free."""

import contextlib
import errno
import os
import socket
from collections import Counter
from pathlib import Path
from typing import List, Optional

from ..places import shown
from ..program import Program
from ..stack import Bus
from .finding import Finding, note, ok, problem
from .ports import PARTICIPANT_INDICES, multicast_ports, unicast_ports
from .sockets import owners, udp_sockets, unix_socket_inode
from .subject import Subject
from .survey import speaks_scarab, who

_TOOLS_BESIDE = 4  # experiment, status and the like, beside the services


def domain(subject: Subject) -> List[Finding]:
    """Who has it."""
    found = []
    for bus in subject.buses:
        own = next((s for s in subject.running if s.bus == bus), None)
        if own:
            found.append(ok(f"DDS domain {bus.domain} is that of the running stack "
                            f"{shown(own.directory.path)}"))
            continue
        keeper = _claimant(bus.domain)
        found.append(_taken(bus.domain, keeper) if keeper else _free(subject, bus))
    return found


def _claimant(number: int) -> Optional[Program]:
    """The keeper of the stack that has claimed the domain (see domain_claim.py)."""
    inode = unix_socket_inode(f"scarab-domain-{number}")
    return None if inode is None else owners([inode])[inode]


def _taken(number: int, keeper: Program) -> Finding:
    return problem(f"DDS domain {number} is in use by another stack: keeper {keeper}"
                   f"{_whereabouts(keeper)}",
                   f"Stop that one (deploy/scarab down in its source tree), or choose another "
                   f"domain: --domain {_next_free(number)}")


def _whereabouts(keeper: Program) -> str:
    """Its log, which is open, lies in the run directory."""
    try:
        log = Path(os.readlink(f"/proc/{keeper.pid}/fd/2"))
    except OSError:
        return ""
    return f", run directory {log.parents[1]}" if log.parent.name == "logs" else ""


def _next_free(number: int) -> int:
    return next(n for n in range(number + 1, 232) if unix_socket_inode(f"scarab-domain-{n}") is None)


def _free(subject: Subject, bus: Bus) -> Finding:
    others = [str(p.program) for p in subject.dds_processes if p.domain == bus.domain]
    others += [who(p) for p in subject.seen(bus).participants
               if p["host"] not in ("", subject.host) and speaks_scarab(p)]
    if not others:
        return ok(f"DDS domain {bus.domain} is free")
    return note(f"no stack of this machine is on DDS domain {bus.domain}, but other DDS programs are: "
                f"{', '.join(others)}",
                "They meet a stack that comes up there; if they should not: --domain "
                f"{_next_free(bus.domain)}")


def ports(subject: Subject) -> List[Finding]:
    """UDP ports of the domain: the shared ones can be shared, enough of the others are left."""
    return [finding for bus in subject.buses for finding in _ports(subject, bus.domain)]


def _ports(subject: Subject, number: int) -> List[Finding]:
    for port in multicast_ports(number):
        holder = _unsharing_holder(port)
        if holder:
            return [problem(f"UDP port {port} of DDS domain {number} is held by {holder}, which "
                            "does not share it, so that no participant can be made",
                            f"Stop that program, or choose another domain: --domain {number + 1}")]
    taken = [s for s in udp_sockets() if (s.port - unicast_ports(number, 0)[0]) % 2 == 0
             and (s.port - unicast_ports(number, 0)[0]) // 2 in PARTICIPANT_INDICES]
    holders = owners(s.inode for s in taken)
    left = len(PARTICIPANT_INDICES) - len({s.port for s in taken})
    most = ", ".join(f"{program} has {count}" for program, count
                     in Counter(holders[s.inode] for s in taken).most_common(3))
    shared = _shared_with_everybody(number)
    text = (f"{left or 'none'} of {len(PARTICIPANT_INDICES)} participant indices of DDS domain "
            f"{number} are left")
    if left < _needed(subject):
        return [problem(f"{text}: {most}",
                        "Stop programs of the domain that are not needed, or choose another one: "
                        f"--domain {number + 1}")]
    return [ok(text), *([shared] if shared else [])]


def _shared_with_everybody(number: int) -> Optional[Finding]:
    first, last = multicast_ports(number)[0], unicast_ports(number, PARTICIPANT_INDICES[-1])[1]
    low, high = map(int, Path("/proc/sys/net/ipv4/ip_local_port_range").read_text().split())
    if last < low or first > high:
        return None
    return note(f"UDP ports {first} to {last} of DDS domain {number} are among those that the system "
                f"gives to any program ({low} to {high}): now and then one of them is taken",
                f"Choose a domain below {(low - 7400) // 250}.")


def _needed(subject: Subject) -> int:
    if subject.running or subject.stack is None:
        return 1  # for the next tool
    return len(subject.stack.processes()) + _TOOLS_BESIDE


def _unsharing_holder(port: int) -> Optional[Program]:
    with contextlib.closing(socket.socket(socket.AF_INET, socket.SOCK_DGRAM)) as trying:
        trying.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # as a participant does
        try:
            trying.bind(("", port))
            return None
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                return None
    inodes = [s.inode for s in udp_sockets() if s.port == port]
    return next(iter(owners(inodes).values()), None)
