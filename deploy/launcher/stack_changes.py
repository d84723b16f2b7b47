"""What a person wants otherwise than stack.yaml says: --replicas, --robot, --driver, --config, --no-log, ..."""

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Dict, Iterable, Optional, Tuple

from .failure import UsageError
from .stack import LOGGER, Service, Stack
from .strict_yaml import did_you_mean

MOST_INSTANCES = 8


@dataclass(frozen=True)
class StackChanges:
    """None and empty: as the file says."""

    robot: Optional[str] = None
    driver: Optional[str] = None
    device: Optional[Path] = None
    emulated: bool = False
    replicas: Dict[str, int] = field(default_factory=dict)
    configs: Dict[str, Path] = field(default_factory=dict)
    interface: Optional[str] = None
    tag: Optional[str] = None
    peers: Optional[Tuple[str, ...]] = None
    log: bool = True


def apply_changes(stack: Stack, changes: StackChanges) -> Stack:
    """The stack with everything but the robot, its driver and its emulation changed, which are known before.

    UsageError for a service that the profile does not have, and for what it cannot take.
    """
    if not changes.log:
        stack = _without_logger(stack)
    _check_names(changes.replicas, "--replicas", (*stack.services, *stack.elsewhere), stack)
    _check_names(changes.configs, "--config", stack.services, stack)
    return replace(
        stack,
        services=tuple(_changed(s, changes) for s in stack.services),
        elsewhere=tuple(_changed(s, changes) for s in stack.elsewhere),
        interface=stack.interface if changes.interface is None else changes.interface,
        tag=stack.tag if changes.tag is None else changes.tag,
        peers=stack.peers if changes.peers is None else changes.peers,
        device=changes.device, emulated=changes.emulated)


def _without_logger(stack: Stack) -> Stack:
    """UsageError where it has none, on this host or another."""
    if all(s.name != LOGGER for s in (*stack.services, *stack.elsewhere)):
        raise UsageError(f"--no-log: profile '{stack.profile}' has no logger")
    return replace(stack, services=tuple(s for s in stack.services if s.name != LOGGER),
                   elsewhere=tuple(s for s in stack.elsewhere if s.name != LOGGER))


def _check_names(names: Iterable[str], option: str, services: Iterable[Service],
                 stack: Stack) -> None:
    known = [s.name for s in services]
    for name in names:
        if name not in known:
            raise UsageError(f"{option}: profile '{stack.profile}' starts no service '{name}'"
                             f"{did_you_mean(name, known)}; it has {', '.join(known)}")


def _changed(service: Service, changes: StackChanges) -> Service:
    count = changes.replicas.get(service.name, service.instances)
    if service.tick_master and count != 1:
        raise UsageError(f"--replicas: {service.name} has the stack's only clock: "
                         "there can be just one of it")
    if service.hardware and count != 1:
        raise UsageError(f"--replicas: {service.name} is hardware: there can be just one of it")
    key = "plant" if service.hardware else "config"  # hardware reads the configuration of who drives it
    own = getattr(service, key)
    file = changes.configs.get(service.name, own)
    if file is not None and own is None:
        raise UsageError(f"--config: {service.name} takes no configuration file")
    if file is not own and not file.is_file():
        raise UsageError(f"--config: {service.name}: there is no file {file}")
    return replace(service, instances=count, **{key: file})
