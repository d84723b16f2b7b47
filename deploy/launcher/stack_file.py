"""Reads stack.yaml into a Stack."""

import re
from pathlib import Path
from typing import Dict, List, Optional

from .failure import UsageError
from .stack import BackOffTimes, Restart, Service, Stack
from .strict_yaml import Value, did_you_mean, read_yaml

_LOG_LEVELS = ("trace", "debug", "info", "warning", "error")
_NAME = re.compile(r"[a-z][a-z0-9_]*\Z")


def read_stack(file: Path, profile: str, root: Path) -> Stack:
    """The profile's stack; paths in the file are relative to `root`.

    ConfigError for a mistake anywhere in the file, UsageError for a profile that is not in it.
    """
    top = read_yaml(file).fields(["bus", "log_level", "timing", "restart", "services", "profiles"])
    bus = top["bus"].fields(["interface", "tag"])
    services = _read_services(top["services"], root)
    chosen = _read_profiles(top["profiles"], services, profile)
    return Stack(
        file=file,
        profile=profile,
        services=tuple(chosen),
        interface=bus["interface"].text(),
        tag=bus["tag"].text(empty=True),
        log_level=top["log_level"].choice(_LOG_LEVELS),
        ready_s=top["timing"].fields(["ready_s"])["ready_s"].number(0.1, 600.0),
        back_off=_read_back_off(top["restart"]),
    )


def _read_back_off(value: Value) -> BackOffTimes:
    fields = value.fields(["first_s", "longest_s", "forget_s"])
    first_s = fields["first_s"].number(0.0, 60.0)
    return BackOffTimes(first_s, fields["longest_s"].number(first_s, 600.0),
                        fields["forget_s"].number(0.0, 86400.0))


def _read_services(value: Value, root: Path) -> Dict[str, Service]:
    services: Dict[str, Service] = {}
    for name, entry in value.mapping().items():
        if not _NAME.match(name):
            entry.fail(f"'{name}' is no service name (small letters, digits and underscores)")
        services[name] = _read_service(name, entry, root)
    return services


def _read_service(name: str, value: Value, root: Path) -> Service:
    fields = value.fields(["binary", "instances", "restart", "stop_s"],
                          ["robot", "config"])
    binary = fields["binary"].text()
    if "/" in binary:
        fields["binary"].fail(f"'{binary}' is a path; expected the name of a program in build/*/bin")
    return Service(
        name=name,
        binary=binary,
        instances=fields["instances"].integer(1, 8),
        restart=Restart(fields["restart"].choice(r.value for r in Restart)),
        stop_s=fields["stop_s"].number(0.1, 600.0),
        robot=_path(fields.get("robot"), root),
        config=_path(fields.get("config"), root),
    )


def _path(value: Optional[Value], root: Path) -> Optional[Path]:
    return root / value.text() if value else None


def _read_profiles(value: Value, services: Dict[str, Service], wanted: str) -> List[Service]:
    chosen = None
    profiles = value.mapping()
    for name, entry in profiles.items():
        fields = entry.fields(["services"], ["unavailable"])
        members = _read_members(fields["services"], services)
        if name != wanted:
            continue
        if "unavailable" in fields:
            raise UsageError(f"profile '{name}' cannot be started: {fields['unavailable'].text()}")
        chosen = members
    if chosen is None:
        raise UsageError(f"no profile '{wanted}'{did_you_mean(wanted, profiles)}; "
                         f"stack.yaml has {', '.join(profiles)}")
    return chosen


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
