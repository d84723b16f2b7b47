"""What a stack in real time would like to have: locked memory and a raised priority. Notes only."""

import os
import resource
from typing import List

from .finding import Finding, note, ok
from .subject import Subject

_CAP_IPC_LOCK = 14
_CAP_SYS_NICE = 23
_LEAST_LOCKED_BYTES = 512 * 1024 * 1024
_LIMITS = "/etc/security/limits.d/scarab.conf"


def realtime(_: Subject) -> List[Finding]:
    lacking, lines = [], []
    locked, _hard = resource.getrlimit(resource.RLIMIT_MEMLOCK)
    if not _capable(_CAP_IPC_LOCK) and 0 <= locked < _LEAST_LOCKED_BYTES:
        lacking.append(f"only {locked // 1024} kB of memory may be locked")
        lines.append("@YOU - memlock unlimited")
    if not _capable(_CAP_SYS_NICE) and resource.getrlimit(resource.RLIMIT_RTPRIO)[0] == 0:
        lacking.append("no real-time priority may be taken")
        lines.append("@YOU - rtprio 50")
    if not lacking:
        return [ok("memory may be locked and priority raised")]
    user = os.environ.get("USER") or str(os.getuid())
    wanted = " and ".join(f"'{line.replace('@YOU', user)}'" for line in lines)
    return [note(f"{' and '.join(lacking)}: ticks in real time may come late on a busy machine",
                 f"As root: put {wanted} into {_LIMITS}, and log in again. Lockstep needs nothing.")]


def _capable(capability: int) -> bool:
    with open("/proc/self/status") as status:
        line = next(text for text in status if text.startswith("CapEff:"))
    return bool(int(line.split()[1], 16) >> capability & 1)
