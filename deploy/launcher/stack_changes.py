"""What a person wants otherwise than stack.yaml says: --replicas, --robot, --config, --no-log, --interface, ..."""

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
    replicas: Dict[str, int] = field(default_factory=dict)
    configs: Dict[str, Path] = field(default_factory=dict)
    interface: Optional[str] = None
    tag: Optional[str] = None
    peers: Optional[Tuple[str, ...]] = None
    log: bool = True


def apply_changes(stack: Stack, changes: StackChanges) -> Stack:
    """The stack with everything but the robot changed, which is known before the file is read.

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
        peers=stack.peers if changes.peers is None else changes.peers)


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
    config = changes.configs.get(service.name, service.config)
    if config is not None and service.config is None:
        raise UsageError(f"--config: {service.name} takes no configuration file")
    if config is not service.config and not config.is_file():
        raise UsageError(f"--config: {service.name}: there is no file {config}")
    return replace(service, instances=count, config=config)
