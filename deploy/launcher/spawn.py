"""Starts a child process that depends on nothing but its arguments and never outlives its parent."""

import ctypes
import os
import signal
import subprocess
from pathlib import Path
from typing import IO, Optional, Sequence, Union

_PR_SET_PDEATHSIG = 1
_KEPT_VARIABLES = ("HOME", "USER", "TERM", "COLUMNS", "NO_COLOR", "TMPDIR", "ASAN_OPTIONS",
                   "UBSAN_OPTIONS", "TSAN_OPTIONS", "LSAN_OPTIONS")
_libc = ctypes.CDLL(None, use_errno=True)

Output = Union[int, IO, None]


def clean_environment() -> dict:
    """Neither a CYCLONEDDS_URI nor a LD_PRELOAD nor a locale of the caller reaches the stack."""
    kept = {name: os.environ[name] for name in _KEPT_VARIABLES if name in os.environ}
    return {"PATH": "/usr/local/bin:/usr/bin:/bin", "LANG": "C.UTF-8", **kept}


def die_with_parent(parent: int) -> None:
    """Called in a child: SIGTERM when the parent ends, however it ends."""
    _libc.prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)
    if os.getppid() != parent:  # it ended before the call
        os._exit(1)


def spawn(command: Sequence[Union[str, Path]], stdout: Output = None, stderr: Output = None,
          cwd: Optional[Path] = None, stdin: Output = subprocess.DEVNULL) -> subprocess.Popen:
    """In a session of its own: Ctrl-C in the terminal reaches the launcher only."""
    parent = os.getpid()
    return subprocess.Popen([str(word) for word in command], stdin=stdin,
                            stdout=stdout, stderr=stderr, cwd=cwd, env=clean_environment(),
                            start_new_session=True, preexec_fn=lambda: die_with_parent(parent))
