"""What a stack in real time would like to have: locked memory and a raised priority. Notes only."""

import ctypes
import os
import resource
from typing import Callable, List

from .finding import Finding, note, ok
from .subject import Subject

_PRIORITY = 20  # what a tick master in real time asks for
_LOCK_ALL = 1 | 2 | 4  # MCL_CURRENT, MCL_FUTURE, MCL_ONFAULT
_LIMITS = "/etc/security/limits.d/scarab.conf"


def realtime(_: Subject) -> List[Finding]:
    """Tries both, in a process that ends at once."""
    lacking, lines = [], []
    user = os.environ.get("USER") or str(os.getuid())
    if not _works(_lock_memory):
        lacking.append(f"memory may not be locked (memlock is {_memlock()})")
        lines.append(f"'{user} - memlock unlimited'")
    if not _works(_raise_priority):
        lacking.append(f"no real-time priority of {_PRIORITY} may be taken")
        lines.append(f"'{user} - rtprio {_PRIORITY}'")
    if not lacking:
        return [ok("memory may be locked and priority raised")]
    return [note(f"{' and '.join(lacking)}: ticks in real time may come late on a busy machine",
                 f"As root: put {' and '.join(lines)} into {_LIMITS}, and log in again. Lockstep needs "
                 "nothing of it.")]


def _works(attempt: Callable[[], bool]) -> bool:
    child = os.fork()
    if child == 0:
        try:
            os._exit(0 if attempt() else 1)
        except BaseException:
            os._exit(1)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0


def _lock_memory() -> bool:
    """Under a limit it may work now, and memory run out at the limit later."""
    return ctypes.CDLL(None).mlockall(_LOCK_ALL) == 0 and (_unlimited() or _may_lock_beyond_limit())


def _raise_priority() -> bool:
    os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(_PRIORITY))
    return True


def _unlimited() -> bool:
    return resource.getrlimit(resource.RLIMIT_MEMLOCK)[0] == resource.RLIM_INFINITY


def _memlock() -> str:
    limit = resource.getrlimit(resource.RLIMIT_MEMLOCK)[0]
    return "unlimited" if limit == resource.RLIM_INFINITY else f"{limit // 1024} kB"


def _may_lock_beyond_limit() -> bool:
    """The capability CAP_IPC_LOCK."""
    with open("/proc/self/status") as status:
        line = next(text for text in status if text.startswith("CapEff:"))
    return bool(int(line.split()[1], 16) >> 14 & 1)
