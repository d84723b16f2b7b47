"""The network interface of the stack: there, up, with an address, and able to do multicast."""

import contextlib
import os
import socket
import struct
from typing import List, Optional

from ..places import shown
from ..stack import Bus
from .finding import Finding, note, ok, problem
from .interfaces import LOOPBACK, MULTICAST, UP, address_of, flags_of, interface_names
from .ports import multicast_ports
from .subject import Subject

_GROUP = "239.255.0.1"  # of DDS discovery (RTPS 2.5, 9.6.2.4); the port is one of our own
_PATIENCE_S = 0.5
_LOOPBACK = "lo"


def network(subject: Subject) -> List[Finding]:
    """Of each interface that a running stack has, or that the stack file names."""
    by_name = {bus.interface: bus for bus in subject.buses}
    found = [finding for name, bus in by_name.items()
             for finding in _interface(subject, name, bool(bus.peers))]
    for bus in by_name.values():
        found += [f for f in (_peer(bus, peer) for peer in bus.peers) if f]
    if _LOOPBACK not in by_name and not (flags_of(_LOOPBACK) or 0) & UP:
        found.append(problem(
            f"interface '{_LOOPBACK}' is down: this machine cannot reach its own addresses, so that "
            "programs on it neither meet nor end", f"As root: ip link set {_LOOPBACK} up"))
    return found


def _interface(subject: Subject, name: str, has_peers: bool) -> List[Finding]:
    where = f"bus.interface in {shown(subject.places.stack_file)}"
    flags = flags_of(name)
    if flags is None:
        return [problem(f"there is no network interface '{name}'; there are: "
                        f"{', '.join(interface_names())}", f"Set {where} to one of them.")]
    if not flags & UP:
        return [problem(f"interface '{name}' is down", f"As root: ip link set {name} up")]
    address = address_of(name)
    if address is None:
        return [problem(f"interface '{name}' has no IPv4 address",
                        f"Give it one (as root: ip address add 10.0.0.1/24 dev {name}), or set "
                        f"{where} to another interface.")]
    found = [ok(f"'{name}' is up, its address is {address}")]
    fault = _multicast_fault(name, address, flags)
    if fault is None:
        return found
    if has_peers:
        return [*found, note(f"no multicast on '{name}' ({fault}); bus.peers makes up for it")]
    return [*found, problem(
        f"no multicast on '{name}' ({fault}), so that nobody is discovered", _advice(name, where))]


def _peer(bus: Bus, peer: str) -> Optional[Finding]:
    """Whether datagrams to it would find a way; not whether somebody is there."""
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as trying:
            trying.connect((peer, multicast_ports(bus.domain)[0]))
    except OSError as error:
        return problem(f"the peer '{peer}' cannot be reached from this host: {error.strerror or error}",
                       "Put right bus.peers in the stack file, or the network: "
                       f"ip route get {peer}")
    return None


def _advice(name: str, where: str) -> str:
    return (f"As root: ip link set {name} multicast on; look for a firewall that drops "
            f"{_GROUP}; where the network has no multicast, list the hosts in bus.peers; or set "
            f"{where} to another interface.")


def _multicast_fault(name: str, address: str, flags: int) -> Optional[str]:
    """None if a datagram to the discovery group comes back. Loopback works without the flag."""
    if not flags & (MULTICAST | LOOPBACK):
        return "it is switched off"
    try:
        return _send_to_group(address)
    except OSError as error:
        return os.strerror(error.errno) if error.errno else str(error)


def _send_to_group(address: str) -> Optional[str]:
    interface = socket.inet_aton(address)
    with contextlib.ExitStack() as sockets:
        receiver = sockets.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        sender = sockets.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        receiver.bind(("", 0))
        receiver.settimeout(_PATIENCE_S)
        receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP,
                            struct.pack("=4s4s", socket.inet_aton(_GROUP), interface))
        sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, interface)
        word = os.urandom(16)
        sender.sendto(word, (_GROUP, receiver.getsockname()[1]))
        try:
            while receiver.recv(64) != word:
                pass
        except socket.timeout:
            return "a datagram that was sent did not come back"
    return None
