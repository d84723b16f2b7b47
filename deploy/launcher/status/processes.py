"""The processes of a stack, as the system and its keeper know them."""

import os
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Dict, List, Optional, Tuple

from ..crash_record import CrashRecord
from ..process_identity import ProcessIdentity, read_json
from ..running_stack import RunningStack

_TICKS_PER_S = os.sysconf("SC_CLK_TCK")
_PAGE_BYTES = os.sysconf("SC_PAGE_SIZE")
KEEPER = "keeper"


@dataclass(frozen=True)
class ProcessView:
    """One process; without a pid it does not run. The keeper and emulated hardware are processes, too, but no
    services: they say nothing on DDS (`speaks`)."""

    name: str
    pid: Optional[int] = None
    uptime_s: float = 0.0
    cpu_s: float = 0.0  # used since its start
    memory_bytes: int = 0
    crashes: CrashRecord = CrashRecord()
    speaks: bool = True

    @property
    def service(self) -> Tuple[str, int]:
        """(name, instance) as in service_status."""
        name, _, instance = self.name.partition("-")
        return name, int(instance or 0)


def processes_of(stack: RunningStack) -> List[ProcessView]:
    """The keeper, then everybody it has to keep running, in start order."""
    views = [replace(_view(KEEPER, stack.keeper, CrashRecord()), speaks=False)]
    for counts, speaks in ((stack.hardware, False), (stack.here, True)):
        for name in expected_processes(counts):
            value = read_json(stack.directory.pid_file_of(name))
            identity = ProcessIdentity.from_json(value) if value else None
            view = _view(name, identity, CrashRecord.read(stack.directory, name))
            views.append(replace(view, speaks=speaks))
    return views


def expected_processes(counts: str) -> List[str]:
    """`plant=1,premotor=2` -> plant, premotor, premotor-1."""
    names = []
    for part in filter(None, counts.split(",")):
        name, count = part.split("=")
        names += [name if i == 0 else f"{name}-{i}" for i in range(int(count))]
    return names


class CpuMeter:
    """Shares of a processor since the last look; of a process first seen, since its start."""

    def __init__(self) -> None:
        self._last: Dict[int, Tuple[float, float]] = {}  # pid -> (when, processor seconds)

    def percent(self, process: ProcessView) -> float:
        now = time.monotonic()
        began, used = self._last.get(process.pid, (now - process.uptime_s, 0.0))
        self._last[process.pid] = (now, process.cpu_s)
        passed = now - began
        return max(0.0, 100.0 * (process.cpu_s - used) / passed) if passed > 0 else 0.0


def _view(name: str, identity: Optional[ProcessIdentity], crashes: CrashRecord) -> ProcessView:
    if identity is None or not identity.alive():
        return ProcessView(name, crashes=crashes)
    try:
        stat = Path(f"/proc/{identity.pid}/stat").read_text().rsplit(")", 1)[1].split()
        pages = int(Path(f"/proc/{identity.pid}/statm").read_text().split()[1])
    except (OSError, IndexError):  # it has ended in this moment
        return ProcessView(name, crashes=crashes)
    since_boot = float(Path("/proc/uptime").read_text().split()[0])
    return ProcessView(
        name, identity.pid, max(0.0, since_boot - int(stat[19]) / _TICKS_PER_S),
        (int(stat[11]) + int(stat[12])) / _TICKS_PER_S, pages * _PAGE_BYTES, crashes)
