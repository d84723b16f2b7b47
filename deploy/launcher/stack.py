"""What a stack consists of: the plain values of stack.yaml."""

import enum
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Dict, Optional, Sequence, Tuple

LOGGER = "logger"  # the service that writes the log


class Restart(enum.Enum):
    """When a service that crashed is started again."""

    ALWAYS = "always"
    BETWEEN_TRIALS = "between_trials"
    NEVER = "never"


class Pace(enum.Enum):
    """What the tick master waits for: the answers of the others, or the wall clock."""

    LOCKSTEP = "lockstep"
    REALTIME = "realtime"

    @property
    def words(self) -> str:
        return "in lockstep" if self is Pace.LOCKSTEP else "in real time"


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
    plant: Optional[Path] = None  # of hardware that is emulated: the simulated robot behind it
    tick_master: bool = False
    paces: Tuple[Pace, ...] = tuple(Pace)  # of a tick master: those that it can go at
    device: bool = False  # it opens one, which --device can name
    hardware: bool = False  # it stands in for a device, and is no service: nobody hears or expects it

    def files(self) -> Dict[str, Path]:
        """What it reads: option -> file."""
        files = {"robot": self.robot, "config": self.config, "plant": self.plant}
        return {option: file for option, file in files.items() if file is not None}

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
    """Where on DDS a stack lives. `peers` are asked for by address where there is no multicast."""

    domain: int
    interface: str
    tag: str
    peers: Tuple[str, ...] = ()

    def arguments(self) -> Tuple[str, ...]:
        tag = ("--tag", self.tag) if self.tag else ()
        peers = ("--peers", ",".join(self.peers)) if self.peers else ()
        return ("--domain", str(self.domain), *tag, "--interface", self.interface, *peers)


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
    elsewhere: Tuple[Service, ...] = ()  # part of the stack, but started on another host
    peers: Tuple[str, ...] = ()
    robot: str = ""
    driver: str = ""  # of a profile with a robot bridge
    device: Optional[Path] = None  # instead of the one that is configured
    emulated: bool = False  # the device is a process of the stack

    def processes(self) -> Tuple[ServiceProcess, ...]:
        return tuple(p for service in self.services for p in service.processes())

    def expected(self) -> str:
        """The value of --expect: who belongs to the stack, here and elsewhere, and how many."""
        return _counts((*self.services, *self.elsewhere))

    def expected_here(self) -> str:
        return _counts(self.services)

    def expected_elsewhere(self) -> str:
        """Empty for a stack on one host."""
        return _counts(self.elsewhere)

    def hardware_here(self) -> str:
        """What stands in for a device: neither heard nor expected on DDS."""
        return ",".join(f"{s.name}={s.instances}" for s in self.services if s.hardware)

    def service(self, name: str) -> Optional[Service]:
        """A service that is started here."""
        return next((s for s in self.services if s.name == name), None)

    def only(self, names: Sequence[str]) -> "Stack":
        """With these services alone."""
        return replace(self, services=tuple(s for s in self.services if s.name in names))

    def tick_master(self) -> Optional[Service]:
        """Whose clock the others follow, where it is started here."""
        return next((s for s in self.services if s.tick_master), None)


def _counts(services: Sequence[Service]) -> str:
    return ",".join(f"{s.name}={s.instances}" for s in services if not s.hardware)
