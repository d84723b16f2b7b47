"""What a stack consists of: the plain values of stack.yaml."""

import enum
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Tuple


class Restart(enum.Enum):
    """When a service that crashed is started again."""

    ALWAYS = "always"
    BETWEEN_TRIALS = "between_trials"
    NEVER = "never"


@dataclass(frozen=True)
class Service:
    """One entry of `services`; `instances` processes run it."""

    name: str
    binary: str
    instances: int
    restart: Restart
    stop_s: float
    robot: Optional[Path] = None
    config: Optional[Path] = None

    def processes(self) -> Tuple["ServiceProcess", ...]:
        return tuple(ServiceProcess(self, i) for i in range(self.instances))


@dataclass(frozen=True)
class ServiceProcess:
    """One process of a service; named like the service, a replica with its instance number."""

    service: Service
    instance: int

    @property
    def name(self) -> str:
        return f"{self.service.name}-{self.instance}" if self.instance else self.service.name


@dataclass(frozen=True)
class BackOffTimes:
    """Waits before the restart of a crashed service."""

    first_s: float
    longest_s: float
    forget_s: float


@dataclass(frozen=True)
class Bus:
    """Where on DDS a stack lives."""

    domain: int
    interface: str
    tag: str

    def arguments(self) -> Tuple[str, ...]:
        tag = ("--tag", self.tag) if self.tag else ()
        return ("--domain", str(self.domain), *tag, "--interface", self.interface)


@dataclass(frozen=True)
class Stack:
    """The services of one profile, in start order. `domain` of the bus is chosen when it starts."""

    file: Path
    profile: str
    services: Tuple[Service, ...]
    interface: str
    tag: str
    log_level: str
    ready_s: float
    back_off: BackOffTimes

    def processes(self) -> Tuple[ServiceProcess, ...]:
        return tuple(p for service in self.services for p in service.processes())

    def expected(self) -> str:
        """The value of --expect: who belongs to the stack, and how many of them."""
        return ",".join(f"{s.name}={s.instances}" for s in self.services)

    def service(self, name: str) -> Optional[Service]:
        return next((s for s in self.services if s.name == name), None)
