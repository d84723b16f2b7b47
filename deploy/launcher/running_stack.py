"""Which stacks of this source tree are running: one small file a domain in `runs/.stacks/`."""

import enum
import signal
from dataclasses import dataclass
from pathlib import Path
from typing import List, Optional

from .failure import Failure
from .process_identity import ProcessIdentity, read_json, write_json
from .run_directory import RunDirectory
from .stack import Bus, Pace

_LEFTOVER_PATIENCE_S = 5.0


class Kind(enum.Enum):
    """A lasting stack was started by `up`; the one of a `run` ends with it."""

    LASTING = "lasting"
    RUN = "run"


@dataclass(frozen=True)
class RunningStack:
    """A stack, the process that keeps it, and where to find both."""

    kind: Kind
    keeper: ProcessIdentity
    bus: Bus
    directory: RunDirectory
    expected: str  # everybody who belongs to it
    ready: bool
    here: str  # those whom this keeper started; the others are on another host
    pace: Pace
    tick_master: str = ""  # the service, where it is one of those
    hardware: str = ""  # what stands in for a device: kept here, but unheard and unexpected

    def write(self, runs: Path) -> None:
        file = _file(runs, self.bus.domain)
        file.parent.mkdir(parents=True, exist_ok=True)
        write_json(file, {
            "kind": self.kind.value, "keeper": self.keeper.to_json(), "domain": self.bus.domain,
            "interface": self.bus.interface, "tag": self.bus.tag, "peers": list(self.bus.peers),
            "directory": str(self.directory.path), "expected": self.expected, "here": self.here,
            "pace": self.pace.value, "tick_master": self.tick_master, "hardware": self.hardware,
            "ready": self.ready})


def forget_stack(runs: Path, domain: int) -> None:
    _file(runs, domain).unlink(missing_ok=True)


def running_stacks(runs: Path) -> List[RunningStack]:
    """All that live, by domain. What a killed keeper left behind is ended and forgotten."""
    found = []
    for file in sorted((runs / ".stacks").glob("domain-*.json")):
        stack = _read(file)
        if stack is None:
            continue
        if stack.keeper.alive():
            found.append(stack)
        else:
            end_leftovers(stack.directory)
            file.unlink(missing_ok=True)
    return sorted(found, key=lambda s: s.bus.domain)


def choose_stack(runs: Path, domain: Optional[int]) -> Optional[RunningStack]:
    """The running stack a command means: that of `domain`, else the only one. Failure if unclear."""
    stacks = [s for s in running_stacks(runs) if domain is None or s.bus.domain == domain]
    if len(stacks) > 1:
        names = ", ".join(str(s.bus.domain) for s in stacks)
        raise Failure(f"stacks run on the domains {names}: say which one with --domain N")
    return stacks[0] if stacks else None


def end_leftovers(directory: RunDirectory) -> List[str]:
    """Ends services whose keeper is gone; their pid files say which processes they are.

    They got SIGTERM when their keeper died; who has not ended in time is killed.
    """
    killed = []
    for file in sorted(directory.pids.glob("*.json")):
        value = read_json(file)
        if value is not None:
            process = ProcessIdentity.from_json(value)
            process.signal(signal.SIGTERM)
            if not process.wait_end(_LEFTOVER_PATIENCE_S):
                process.signal(signal.SIGKILL)
                process.wait_end(_LEFTOVER_PATIENCE_S)
                killed.append(file.stem)
        file.unlink(missing_ok=True)
    return killed


def _file(runs: Path, domain: int) -> Path:
    return runs / ".stacks" / f"domain-{domain}.json"


def _read(file: Path) -> Optional[RunningStack]:
    value = read_json(file)
    if value is None:
        return None
    try:
        return RunningStack(
            Kind(value["kind"]), ProcessIdentity.from_json(value["keeper"]),
            Bus(value["domain"], value["interface"], value["tag"], tuple(value["peers"])),
            RunDirectory(Path(value["directory"])), value["expected"], value["ready"],
            value["here"], Pace(value["pace"]), value["tick_master"], value.get("hardware", ""))
    except (KeyError, ValueError, TypeError):
        return None
