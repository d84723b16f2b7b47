"""The network interfaces of this machine."""

import fcntl
import os
import socket
import struct
from typing import Dict, List, Optional

UP = 0x1
LOOPBACK = 0x8
MULTICAST = 0x1000
_SIOCGIFFLAGS = 0x8913
_SIOCGIFADDR = 0x8915


def interface_names() -> List[str]:
    return sorted(name for _, name in socket.if_nameindex())


def flags_of(name: str) -> Optional[int]:
    """As in <net/if.h>; None where there is no such interface."""
    answer = _ask(name, _SIOCGIFFLAGS)  # /sys/class/net may be another network namespace's
    return None if answer is None else struct.unpack_from("=H", answer, 16)[0]


def address_of(name: str) -> Optional[str]:
    """Its first IPv4 address, or None."""
    answer = _ask(name, _SIOCGIFADDR)
    return None if answer is None else socket.inet_ntoa(answer[20:24])


def names_by_address() -> Dict[str, str]:
    addresses = {address_of(name): name for name in interface_names()}
    return {address: name for address, name in addresses.items() if address}


def usable_interfaces() -> List[str]:
    """Up, and with an IPv4 address."""
    return [name for name in interface_names()
            if (flags_of(name) or 0) & UP and address_of(name)]


def _ask(name: str, request: int) -> Optional[bytes]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
        try:
            return fcntl.ioctl(asking, request, struct.pack("=16s24x", os.fsencode(name)[:15]))
        except OSError:
            return None
