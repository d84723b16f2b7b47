"""Which process is meant: pid, start time and boot, so that a recycled pid is never taken for it."""

import json
import os
import select
import signal
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Optional


@dataclass(frozen=True)
class ProcessIdentity:
    """A pid is recycled after the process has ended; its start time (clock ticks since boot) is not."""

    pid: int
    start_ticks: int
    boot_id: str

    @staticmethod
    def of(pid: int) -> Optional["ProcessIdentity"]:
        """The identity of a process that lives (a zombie does not), or None."""
        try:
            stat = Path(f"/proc/{pid}/stat").read_text()
        except (FileNotFoundError, ProcessLookupError):
            return None
        fields = stat.rsplit(")", 1)[1].split()  # the name before may hold spaces and brackets
        if fields[0] in ("Z", "X"):
            return None
        return ProcessIdentity(pid, int(fields[19]), _boot_id())

    def alive(self) -> bool:
        return ProcessIdentity.of(self.pid) == self

    def signal(self, number: int) -> bool:
        """Sends a signal to exactly this process; False if it is gone."""
        handle = self._open()
        if handle is None:
            return False
        try:
            signal.pidfd_send_signal(handle, number)
            return True
        except ProcessLookupError:
            return False
        finally:
            os.close(handle)

    def wait_end(self, timeout_s: float) -> bool:
        """Waits until it has ended; False if it still lives after the time."""
        handle = self._open()
        if handle is None:
            return True
        try:
            return bool(select.select([handle], [], [], timeout_s)[0])
        finally:
            os.close(handle)

    def _open(self) -> Optional[int]:
        try:
            handle = os.pidfd_open(self.pid)
        except ProcessLookupError:
            return None
        if self.alive():  # checked with the handle held: from here on the pid cannot be another's
            return handle
        os.close(handle)
        return None

    def to_json(self) -> dict:
        return asdict(self)

    @staticmethod
    def from_json(value: dict) -> "ProcessIdentity":
        return ProcessIdentity(int(value["pid"]), int(value["start_ticks"]), str(value["boot_id"]))


def _boot_id() -> str:
    return Path("/proc/sys/kernel/random/boot_id").read_text().strip()


def write_text(file: Path, text: str) -> None:
    """Replaces the file in one step: a reader sees the old or the new text, never half of one."""
    temporary = file.with_name(file.name + ".new")
    temporary.write_text(text + "\n")
    os.replace(temporary, file)


def write_json(file: Path, value: dict) -> None:
    """As write_text."""
    write_text(file, json.dumps(value, indent=1))


def read_json(file: Path) -> Optional[dict]:
    """The file's object, or None where there is none (or no longer a readable one)."""
    try:
        value = json.loads(file.read_text())
    except (OSError, ValueError):
        return None
    return value if isinstance(value, dict) else None
