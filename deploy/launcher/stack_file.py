"""Reads stack.yaml into a Stack: its shape is declared, what its parts say of each other is here."""

from dataclasses import replace
from pathlib import Path
from typing import Dict, List

from .driver_choice import chosen_driver
from .failure import UsageError
from .marked_paths import MarkedPaths
from .profile import Profile, read_profile
from .robot_choice import chosen_robot
from .stack import BackOffTimes, Pace, Restart, Service, Stack
from .stack_changes import StackChanges, apply_changes
from .stack_declaration import STACK
from .strict_yaml import Value, did_you_mean, read_yaml


def read_stack(file: Path, profile: str, root: Path,
               changes: StackChanges = StackChanges()) -> Stack:
    """The profile's stack, changed as asked for; paths in the file are relative to `root`.

    ConfigError for a mistake anywhere in the file, UsageError for a profile that is not in it, and
    for changes that do not fit.
    """
    value = read_yaml(file)
    read = STACK.read(value)
    robot = chosen_robot(read.get("robot", ""), changes.robot, root)
    driver = chosen_driver(read.get("driver", ""), changes.driver, robot, root)
    paths = MarkedPaths(root, {"robot": robot, "driver": driver})
    services = {name: _service(name, fields, value.at("services", name), paths)
                for name, fields in read["services"].items()}
    profiles = {name: read_profile(value.at("profiles", name), services) for name in read["profiles"]}
    if profile not in profiles:
        raise UsageError(f"no profile '{profile}'{did_you_mean(profile, profiles)}; "
                         f"stack.yaml has {', '.join(profiles)}")
    _check_device_options(changes, profile, profiles)
    chosen, bus = profiles[profile], read["bus"]
    here = chosen.with_emulated(services) if changes.emulated else chosen.here
    stack = apply_changes(Stack(
        file=file, profile=profile, services=here, elsewhere=chosen.elsewhere,
        interface=bus["interface"], tag=bus["tag"], peers=tuple(bus.get("peers", ())),
        log_level=read["log_level"], ready_s=read["timing"]["ready_s"],
        back_off=_back_off(read["restart"], value.at("restart")), robot=robot,
        driver=driver if paths.depend_on("driver", here) else ""), changes)
    paths.check_files(stack.services)
    return _with_files_of_hardware(stack)


def read_profiles(file: Path) -> List[str]:
    """The names of the profiles."""
    return list(STACK.read(read_yaml(file))["profiles"])


def _back_off(read: Dict[str, float], value: Value) -> BackOffTimes:
    times = BackOffTimes(**read)
    if times.longest_s < times.first_s:
        value.at("longest_s").fail(f"{times.longest_s:g} is less than first_s")
    return times


def _service(name: str, read: Dict[str, object], value: Value, paths: MarkedPaths) -> Service:
    if read.get("tick_master") and read["instances"] != 1:
        value.at("instances").fail("must be 1: the tick master has the stack's only clock")
    for key in ("paces", "device"):
        if key in read and not read.get("tick_master"):
            value.at(key).fail("is of the tick master alone")
    if read.get("hardware"):
        _check_hardware(read, value)
    elif "plant" in read:
        value.at("plant").fail("is of hardware alone")
    chosen = {key: paths.fill_in(read[key], value.at(key))
              for key in ("robot", "config", "plant") if key in read}
    if "paces" in read:
        chosen["paces"] = tuple(map(Pace, read["paces"]))
    return Service(name=name, **{**read, **chosen, "restart": Restart(read["restart"])})


def _with_files_of_hardware(stack: Stack) -> Stack:
    """It is described by the files of the tick master that drives it."""
    master = stack.tick_master()
    return replace(stack, services=tuple(
        replace(s, robot=master.robot, config=master.config) if s.hardware and master else s
        for s in stack.services))


def _check_hardware(read: Dict[str, object], value: Value) -> None:
    for key in ("tick_master", "robot", "config"):
        if read.get(key):
            value.at(key).fail("is not of hardware: that has the files of the tick master whose device it is")
    if read["instances"] != 1:
        value.at("instances").fail("must be 1: the tick master has one device")


def _check_device_options(changes: StackChanges, profile: str, profiles: Dict[str, Profile]) -> None:
    """UsageError for options of a device with a profile that drives none."""
    given = {"--driver": changes.driver is not None, "--device": changes.device is not None,
             "--emulated": changes.emulated}
    fitting = {name: p.emulated if changes.emulated else p.drives_a_device() for name, p in profiles.items()}
    for option, is_given in given.items():
        if is_given and not fitting[profile]:
            others = " or ".join(name for name, fits in fitting.items() if fits)
            lacks = "names no hardware to emulate" if option == "--emulated" else "drives no device"
            raise UsageError(f"{option}: profile '{profile}' {lacks}"
                             + (f"; with --profile {others} it can be said" if others else ""))
    if changes.emulated and changes.device is not None:
        raise UsageError("--device and --emulated contradict each other: what is emulated is the device")
