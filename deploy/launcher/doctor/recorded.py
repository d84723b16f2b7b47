"""The stacks that this source tree has noted down, dead ones too; looked at, never cleaned up."""

from dataclasses import dataclass
from pathlib import Path
from typing import List, Optional

from ..process_identity import ProcessIdentity, read_json
from ..run_directory import RunDirectory
from ..stack import Bus


@dataclass(frozen=True)
class RecordedStack:
    """What `runs/.stacks/domain-N.json` says."""

    file: Path
    keeper: ProcessIdentity
    bus: Bus
    directory: RunDirectory
    ready: bool
    expected: str  # everybody who belongs to it, here and on other hosts

    def alive(self) -> bool:
        return self.keeper.alive()


def recorded_stacks(runs: Path) -> List[RecordedStack]:
    """By domain. A file that cannot be read is no stack."""
    files = sorted((runs / ".stacks").glob("domain-*.json"))
    stacks = [stack for stack in map(_read, files) if stack is not None]
    return sorted(stacks, key=lambda s: s.bus.domain)


def _read(file: Path) -> Optional[RecordedStack]:
    value = read_json(file)
    if value is None:
        return None
    try:
        return RecordedStack(
            file, ProcessIdentity.from_json(value["keeper"]),
            Bus(int(value["domain"]), str(value["interface"]), str(value["tag"]),
                tuple(value.get("peers", ()))),
            RunDirectory(Path(value["directory"])), bool(value["ready"]), str(value["expected"]))
    except (KeyError, ValueError, TypeError):
        return None
