"""Who holds which socket of this network namespace, from /proc."""

import os
import socket
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterable, List, Optional, Set

from ..program import Program, program

@dataclass(frozen=True)
class UdpSocket:
    """A bound UDP socket; `address` is empty for one that is bound to all addresses."""

    address: str
    port: int
    inode: int


ANOTHER_USERS = Program(0, "a program of another user")


def udp_sockets() -> List[UdpSocket]:
    found = []
    for table in ("udp", "udp6"):
        try:
            lines = Path(f"/proc/net/{table}").read_text().splitlines()[1:]
        except OSError:  # no IPv6 here
            continue
        for line in lines:
            fields = line.split()
            address, port = fields[1].split(":")
            found.append(UdpSocket(_address(address), int(port, 16), int(fields[9])))
    return found


def unix_socket_inode(name: str) -> Optional[int]:
    """Of a bound abstract socket, or None."""
    for line in Path("/proc/net/unix").read_text().splitlines()[1:]:
        fields = line.split(maxsplit=7)
        if len(fields) == 8 and fields[7] == f"@{name}":
            return int(fields[6])
    return None


def owners(inodes: Iterable[int]) -> Dict[int, Program]:
    """Inode -> the process that holds that socket (the first one, of those that share it)."""
    wanted = set(inodes)
    found: Dict[int, Program] = {}
    for pid in sorted(int(name) for name in os.listdir("/proc") if name.isdigit()):
        for inode in _socket_inodes(pid) & wanted:
            found.setdefault(inode, program(pid))
    return {inode: found.get(inode, ANOTHER_USERS) for inode in wanted}


def _socket_inodes(pid: int) -> Set[int]:
    inodes = set()
    try:
        for descriptor in os.scandir(f"/proc/{pid}/fd"):
            target = os.readlink(descriptor.path)
            if target.startswith("socket:["):
                inodes.add(int(target[8:-1]))
    except OSError:  # it has ended, or is another user's
        pass
    return inodes


def _address(text: str) -> str:
    if len(text) != 8 or int(text, 16) == 0:
        return ""
    return socket.inet_ntoa(struct.pack("=I", int(text, 16)))
