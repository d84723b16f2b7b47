"""The robot: of a stack that runs, of the profile that is asked for, or one that is just plugged in."""

from pathlib import Path
from typing import List, Optional, Tuple

from ..device_port import holders_of, listed, obstacle_at, port_of, usual_ports
from ..failure import Failure
from ..places import shown
from ..preflight import ask
from ..process_identity import ProcessIdentity, read_json
from ..stack import Stack
from ..stack_file import read_profiles, read_stack
from .driven import Driven, driven_by
from .finding import Finding, note, ok, problem
from .recorded import RecordedStack
from .subject import Subject


def device(subject: Subject) -> List[Finding]:
    """A profile that was named is looked at; without one, what runs, and else what is there."""
    if subject.options.profile is not None:
        return [_of_profile(subject, subject.stack)]
    if subject.running:
        return [_of_running(stack) for stack in subject.running]
    return [_of_nobody(subject)]


def _of_profile(subject: Subject, stack: Optional[Stack]) -> Finding:
    if not _drives(stack):
        return ok("the profile drives no robot")
    try:
        port = _port_of(subject, stack)
    except Failure as refused:
        return note(f"not looked at: {refused}")
    if port is None:
        return ok(f"driver {stack.driver} opens no port")
    holders = holders_of(port)
    if holders and {h.pid for h in holders} <= {pid for s in subject.running for pid in _pids_of(s)}:
        return ok(f"{port} is open in {holders[0]} of the stack that is up")
    obstacle = obstacle_at(port)
    if obstacle:
        return problem(obstacle.what, f"{obstacle.advice}.")
    return ok(f"{port} is there, may be opened, and is free")


def _of_running(stack: RecordedStack) -> Finding:
    """As its own files say, not as the options of this command do."""
    up, driven = f"the stack on DDS domain {stack.bus.domain}", driven_by(stack.directory)
    if driven is None:
        return ok(f"{up} drives no robot here")
    if driven.port is None:
        return ok(f"{up}: driver {driven.driver} opens no port")
    if not driven.port.exists():
        return problem(*_missed(up, driven))
    ours, bridge = _pids_of(stack), _pid_of(stack, driven.bridge)
    holders = holders_of(driven.port)
    others = [h for h in holders if h.pid not in ours]
    if others:
        return problem(f"{driven.port}, the robot of {up}, is open in {listed(others)}, too",
                       "Stop that: two programs at one port garble each other's frames.")
    emulated = ", an emulated robot," if driven.emulated else ""
    if any(h.pid == bridge for h in holders):
        return ok(f"{driven.port}{emulated} is open in {driven.bridge} of {up}")
    return note(f"{driven.port}{emulated} is there, but {driven.bridge} of {up} does not have it open",
                "deploy/scarab status says what it waits for.")


def _missed(up: str, driven: Driven) -> Tuple[str, str]:
    if driven.emulated:
        return (f"the emulated robot of {up} is not at {driven.port}",
                f"It was told to be unplugged (deploy/scarab emulator tell {shown(driven.port.parent)} clear), or its "
                "program does not run "
                "(deploy/scarab logs emulator).")
    return (f"the robot of {up} is not at {driven.port}",
            f"Plug it in again: {driven.bridge} then finds it by itself.")


def _of_nobody(subject: Subject) -> Finding:
    """Nobody asks for a robot, so that none is missed; but one that is there is told of."""
    for profile in _profiles(subject):
        try:
            stack = read_stack(subject.places.stack_file, profile, subject.places.root)
            port = _port_of(subject, stack) if _drives(stack) and not stack.elsewhere else None
        except Failure:  # other checks tell of that
            continue
        if port is not None and port.exists():
            obstacle = obstacle_at(port)
            return note(f"a robot may be at {port}, but {obstacle.what}", f"{obstacle.advice}.") if obstacle else \
                ok(f"a robot may be at {port}, which is free: `up --profile {profile}` drives it")
    ports = usual_ports()
    others = f"; there are {', '.join(ports)}, which --profile robot --device PATH can name" if ports else ""
    return ok(f"no stack runs that could drive a robot, and none is where it is configured{others}")


def _profiles(subject: Subject) -> List[str]:
    return read_profiles(subject.places.stack_file) if subject.stack else []


def _drives(stack: Optional[Stack]) -> bool:
    master = stack.tick_master() if stack else None
    return master is not None and master.device


def _port_of(subject: Subject, stack: Stack) -> Optional[Path]:
    """Of a stack that drives a device. Failure where its bridge refuses its configuration, or is not built."""
    master = stack.tick_master()
    return port_of(stack, {f"{master.name}.yaml": ask(subject.places, master, "--dump-config")})


def _pids_of(stack: RecordedStack) -> List[int]:
    """The processes of a running stack of this source tree."""
    values = map(read_json, stack.directory.pids.glob("*.json"))
    return [ProcessIdentity.from_json(value).pid for value in values if value is not None]


def _pid_of(stack: RecordedStack, service: str) -> Optional[int]:
    value = read_json(stack.directory.pid_file_of(service))
    return None if value is None else ProcessIdentity.from_json(value).pid
