"""At most one stack of a launcher on each DDS domain of this machine."""

import errno
import socket
from typing import Optional

from .failure import Failure

_DOMAINS = range(0, 100)


class DomainClaim:
    """Held as an abstract socket: those are per network namespace, as loopback DDS traffic is, and
    vanish with the process that holds them, however it ends. A fork shares the claim."""

    def __init__(self, domain: int):
        """Failure where another stack has it."""
        self.domain = domain
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            self._socket.bind(f"\0scarab-domain-{domain}")
        except OSError as error:
            self._socket.close()
            if error.errno != errno.EADDRINUSE:
                raise Failure(f"cannot claim DDS domain {domain}: {error.strerror}") from None
            raise Failure(f"DDS domain {domain} is in use by another stack of this machine: "
                          "stop it (scarab down), or choose another one with --domain N") from None

    @property
    def descriptor(self) -> int:
        return self._socket.fileno()

    def release(self) -> None:
        self._socket.close()


def claim_domain(wanted: Optional[int]) -> DomainClaim:
    """The wanted domain, or without a wish the lowest free one."""
    if wanted is not None:
        return DomainClaim(wanted)
    for domain in _DOMAINS:
        try:
            return DomainClaim(domain)
        except Failure:
            continue
    raise Failure(f"the DDS domains 0 to {_DOMAINS[-1]} are all in use by other stacks")
