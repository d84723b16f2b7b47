"""A process in words, for a person who has to find it."""

import os
from dataclasses import dataclass
from pathlib import Path

_INTERPRETERS = ("python", "bash", "sh", "perl", "ruby", "node")


@dataclass(frozen=True)
class Program:
    """Pid 0: the system does not tell, it is another user's."""

    pid: int
    name: str

    def __str__(self) -> str:
        return f"{self.name} (pid {self.pid})" if self.pid else self.name


def program(pid: int) -> Program:
    """Named by its file, a script by the script's."""
    try:
        words = Path(f"/proc/{pid}/cmdline").read_bytes().decode(errors="replace").split("\0")
    except OSError:
        words = []
    name = os.path.basename(words[0]) if words and words[0] else f"process {pid}"
    if name.startswith(_INTERPRETERS) and len(words) > 1 and words[1][:1] not in ("", "-"):
        name = os.path.basename(words[1])
    return Program(pid, name)
