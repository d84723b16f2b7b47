"""The port that a robot is at: which one, and what keeps the bridge from opening it."""

import glob
import grp
import os
import pwd
import stat
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Optional, Sequence

import yaml

from .failure import Failure
from .program import Program, program
from .stack import Stack

_NAMED = 3  # of the programs that have a port open
_USUAL_PLACES = ("/dev/serial/by-id/*", "/dev/ttyUSB*", "/dev/ttyACM*", "/dev/ttyAMA*")


@dataclass(frozen=True)
class Obstacle:
    """`what` is the case, and what to do about it."""

    what: str
    advice: str


def check_port(stack: Stack, texts: Dict[str, str]) -> None:
    """Failure where the bridge of the stack could not open its port; `texts` are the resolved files. The bridge
    would wait for it, which is right for a robot that was unplugged, but not for one that was never there."""
    port = port_of(stack, texts)
    obstacle = obstacle_at(port) if port else None
    if obstacle:
        raise Failure(f"{obstacle.what}. {obstacle.advice}")


def port_of(stack: Stack, texts: Dict[str, str]) -> Optional[Path]:
    """None for a stack that drives no device, or an emulated one, or by a driver without a port."""
    master = stack.tick_master()
    if master is None or not master.device or stack.emulated:
        return None
    if stack.device is not None:
        return stack.device
    resolved = yaml.safe_load(texts.get(f"{master.name}.yaml", "")) or {}
    port = (resolved.get(resolved.get("driver")) or {}).get("port")
    return Path(str(port)) if port else None


def obstacle_at(port: Path) -> Optional[Obstacle]:
    """It is looked at and not opened: that alone resets some boards, by their DTR line."""
    try:
        status = port.stat()
    except OSError:
        return Obstacle(f"there is no {port}", f"Plug the robot in, or say where it is: --device PATH{_there()}. "
                                               "Without a robot: --emulated")
    if not stat.S_ISCHR(status.st_mode) or not _may_be_a_terminal(status.st_rdev):
        return Obstacle(f"{port} is no serial port", f"Say where the robot is: --device PATH{_there()}")
    if not os.access(port, os.R_OK | os.W_OK):
        group = _name_of(status.st_gid)
        return Obstacle(f"{port} may not be opened: it is for group {group}",
                        f"As root: usermod -a -G {group} {_user()}; then log in again")
    others = holders_of(port)
    if others:
        return Obstacle(f"{port} is open in {listed(others)}",
                        "Stop that first: two programs at one port garble each other's frames")
    return None


def holders_of(port: Path) -> List[Program]:
    """The processes that have it open, as far as the system tells: of other users it does not."""
    real, found = os.path.realpath(port), []
    for pid in sorted(int(name) for name in os.listdir("/proc") if name.isdigit()):
        try:
            if any(os.readlink(entry.path) == real for entry in os.scandir(f"/proc/{pid}/fd")):
                found.append(program(pid))
        except OSError:  # it has ended, or is another user's
            pass
    return found


def listed(programs: Sequence[Program]) -> str:
    """The first few of them."""
    more = len(programs) - _NAMED
    return ", ".join(map(str, programs[:_NAMED])) + (f" and {more} more" if more > 0 else "")


def _may_be_a_terminal(device: int) -> bool:
    """Of some devices the system knows that they are something else, such as /dev/null."""
    kind = Path(f"/sys/dev/char/{os.major(device)}:{os.minor(device)}/subsystem")
    return not kind.exists() or kind.resolve().name == "tty"


def usual_ports() -> List[str]:
    """The serial ports of this computer, where they usually are."""
    return sorted(path for place in _USUAL_PLACES for path in glob.glob(place))


def _there() -> str:
    found = usual_ports()
    return f" (there are {', '.join(found)})" if found else ""


def _name_of(group: int) -> str:
    try:
        return grp.getgrgid(group).gr_name
    except KeyError:
        return str(group)


def _user() -> str:
    try:
        return pwd.getpwuid(os.getuid()).pw_name
    except KeyError:
        return str(os.getuid())
