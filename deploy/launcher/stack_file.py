"""Reads stack.yaml into a Stack."""

import re
from pathlib import Path
from typing import Dict, List, Optional, Tuple

from .failure import UsageError
from .robot_choice import RobotChoice
from .stack import BackOffTimes, Restart, Service, Stack
from .stack_changes import MOST_INSTANCES, StackChanges, apply_changes
from .strict_yaml import Value, did_you_mean, read_yaml

_LOG_LEVELS = ("trace", "debug", "info", "warning", "error")
_NAME = re.compile(r"[a-z][a-z0-9_]*\Z")


def read_stack(file: Path, profile: str, root: Path,
               changes: StackChanges = StackChanges()) -> Stack:
    """The profile's stack, changed as asked for; paths in the file are relative to `root`.

    ConfigError for a mistake anywhere in the file, UsageError for a profile that is not in it, and
    for changes that do not fit.
    """
    top = read_yaml(file).fields(["bus", "log_level", "timing", "restart", "services", "profiles"],
                                 ["robot"])
    bus = top["bus"].fields(["interface", "tag"], ["peers"])
    robot = RobotChoice(top.get("robot"), changes.robot, root)
    services = _read_services(top["services"], robot)
    chosen, elsewhere = _read_profiles(top["profiles"], services, profile)
    stack = Stack(
        file=file,
        profile=profile,
        services=tuple(chosen),
        elsewhere=tuple(elsewhere),
        interface=bus["interface"].text(),
        tag=bus["tag"].text(empty=True),
        peers=tuple(p.text() for p in bus["peers"].sequence()) if "peers" in bus else (),
        log_level=top["log_level"].choice(_LOG_LEVELS),
        ready_s=top["timing"].fields(["ready_s"])["ready_s"].number(0.1, 600.0),
        back_off=_read_back_off(top["restart"]),
        robot=robot.name,
    )
    stack = apply_changes(stack, changes)
    robot.check_files(stack.services)
    return stack


def read_profiles(file: Path) -> List[str]:
    """The names of the profiles."""
    return list(read_yaml(file).mapping()["profiles"].mapping())


def _read_back_off(value: Value) -> BackOffTimes:
    fields = value.fields(["first_s", "longest_s", "forget_s"])
    first_s = fields["first_s"].number(0.0, 60.0)
    return BackOffTimes(first_s, fields["longest_s"].number(first_s, 600.0),
                        fields["forget_s"].number(0.0, 86400.0))


def _read_services(value: Value, robot: RobotChoice) -> Dict[str, Service]:
    services: Dict[str, Service] = {}
    for name, entry in value.mapping().items():
        if not _NAME.match(name):
            entry.fail(f"'{name}' is no service name (small letters, digits and underscores)")
        services[name] = _read_service(name, entry, robot)
    return services


def _read_service(name: str, value: Value, robot: RobotChoice) -> Service:
    fields = value.fields(["binary", "instances", "restart", "stop_s"],
                          ["robot", "config", "tick_master"])
    binary = fields["binary"].text()
    if "/" in binary:
        fields["binary"].fail(f"'{binary}' is a path; expected the name of a program in build/*/bin")
    instances = fields["instances"].integer(1, MOST_INSTANCES)
    tick_master = "tick_master" in fields and fields["tick_master"].boolean()
    if tick_master and instances != 1:
        fields["instances"].fail("must be 1: the tick master has the stack's only clock")

    def path(key: str) -> Optional[Path]:
        return robot.fill_in(fields[key]) if key in fields else None

    return Service(
        name=name,
        binary=binary,
        instances=instances,
        restart=Restart(fields["restart"].choice(r.value for r in Restart)),
        stop_s=fields["stop_s"].number(0.1, 600.0),
        robot=path("robot"),
        config=path("config"),
        tick_master=tick_master,
    )


def _read_profiles(value: Value, services: Dict[str, Service],
                   wanted: str) -> Tuple[List[Service], List[Service]]:
    """The services of the wanted profile: those started here, and those elsewhere."""
    chosen = None
    profiles = value.mapping()
    for name, entry in profiles.items():
        fields = entry.fields(["services"], ["elsewhere", "unavailable"])
        members = _read_members(fields["services"], services)
        elsewhere = _read_members(fields["elsewhere"], services) if "elsewhere" in fields else []
        _check_together(entry, members, elsewhere)
        if name != wanted:
            continue
        if "unavailable" in fields:
            raise UsageError(f"profile '{name}' cannot be started: {fields['unavailable'].text()}")
        chosen = members, elsewhere
    if chosen is None:
        raise UsageError(f"no profile '{wanted}'{did_you_mean(wanted, profiles)}; "
                         f"stack.yaml has {', '.join(profiles)}")
    return chosen


def _check_together(value: Value, here: List[Service], elsewhere: List[Service]) -> None:
    for service in here:
        if service in elsewhere:
            value.fail(f"service '{service.name}' is both here and elsewhere")
    clocks = [s.name for s in (*here, *elsewhere) if s.tick_master]
    if len(clocks) > 1:
        value.fail(f"has {len(clocks)} tick masters ({', '.join(clocks)}); there can be just one")


def _read_members(value: Value, services: Dict[str, Service]) -> List[Service]:
    names: List[str] = []
    for item in value.sequence():
        name = item.choice(services)
        if name in names:
            item.fail(f"service '{name}' is listed twice")
        names.append(name)
    if not names:
        value.fail("must name at least one service")
    order = list(services)
    if names != sorted(names, key=order.index):
        value.fail("must be in the order of `services`, which is the order of starting")
    return [services[name] for name in names]
