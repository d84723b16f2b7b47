"""Reads stack.yaml into a Stack: its shape is declared, what its parts say of each other is here."""

from pathlib import Path
from typing import Dict, List, Tuple

from .failure import UsageError
from .robot_choice import RobotChoice
from .stack import BackOffTimes, Restart, Service, Stack
from .stack_changes import StackChanges, apply_changes
from .stack_declaration import STACK
from .strict_yaml import Value, did_you_mean, read_yaml

Services = Dict[str, Service]


def read_stack(file: Path, profile: str, root: Path,
               changes: StackChanges = StackChanges()) -> Stack:
    """The profile's stack, changed as asked for; paths in the file are relative to `root`.

    ConfigError for a mistake anywhere in the file, UsageError for a profile that is not in it, and
    for changes that do not fit.
    """
    value = read_yaml(file)
    read = STACK.read(value)
    robot = RobotChoice(read.get("robot", ""), changes.robot, root)
    services = {name: _service(name, fields, value.at("services", name), robot)
                for name, fields in read["services"].items()}
    here, elsewhere = _profile(read["profiles"], value.at("profiles"), services, profile)
    bus = read["bus"]
    stack = apply_changes(Stack(
        file=file, profile=profile, services=tuple(here), elsewhere=tuple(elsewhere),
        interface=bus["interface"], tag=bus["tag"], peers=tuple(bus.get("peers", ())),
        log_level=read["log_level"], ready_s=read["timing"]["ready_s"],
        back_off=_back_off(read["restart"], value.at("restart")), robot=robot.name), changes)
    robot.check_files(stack.services)
    return stack


def read_profiles(file: Path) -> List[str]:
    """The names of the profiles."""
    return list(STACK.read(read_yaml(file))["profiles"])


def _back_off(read: Dict[str, float], value: Value) -> BackOffTimes:
    times = BackOffTimes(**read)
    if times.longest_s < times.first_s:
        value.at("longest_s").fail(f"{times.longest_s:g} is less than first_s")
    return times


def _service(name: str, read: Dict[str, object], value: Value, robot: RobotChoice) -> Service:
    if read.get("tick_master") and read["instances"] != 1:
        value.at("instances").fail("must be 1: the tick master has the stack's only clock")
    files = {key: robot.fill_in(read[key], value.at(key))
             for key in ("robot", "config") if key in read}
    return Service(name=name, **{**read, **files, "restart": Restart(read["restart"])})


def _profile(read: Dict[str, dict], value: Value, services: Services,
             wanted: str) -> Tuple[List[Service], List[Service]]:
    """The services of the wanted profile: those started here, and those elsewhere. Checks all profiles."""
    sides = {name: _sides(value.at(name), services) for name in read}
    if wanted not in read:
        raise UsageError(f"no profile '{wanted}'{did_you_mean(wanted, read)}; "
                         f"stack.yaml has {', '.join(read)}")
    if "unavailable" in read[wanted]:
        raise UsageError(f"profile '{wanted}' cannot be started: {read[wanted]['unavailable']}")
    return sides[wanted]


def _sides(value: Value, services: Services) -> Tuple[List[Service], List[Service]]:
    fields = value.mapping()
    here = _members(fields["services"], services)
    elsewhere = _members(fields["elsewhere"], services) if "elsewhere" in fields else []
    for service in here:
        if service in elsewhere:
            value.fail(f"service '{service.name}' is both here and elsewhere")
    clocks = [s.name for s in (*here, *elsewhere) if s.tick_master]
    if len(clocks) > 1:
        value.fail(f"has {len(clocks)} tick masters ({', '.join(clocks)}); there can be just one")
    return here, elsewhere


def _members(value: Value, services: Services) -> List[Service]:
    names: List[str] = []
    for item in value.sequence():
        name = item.choice(services)
        if name in names:
            item.fail(f"service '{name}' is listed twice")
        names.append(name)
    order = list(services)
    if names != sorted(names, key=order.index):
        value.fail("must be in the order of `services`, which is the order of starting")
    return [services[name] for name in names]
