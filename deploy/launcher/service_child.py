"""One process of the stack as its keeper sees it."""

import signal
import subprocess
import time
from contextlib import suppress
from pathlib import Path
from typing import Callable, List, Optional, Sequence

from .back_off import BackOff
from .crash_record import CrashRecord
from .process_identity import ProcessIdentity, write_json
from .run_directory import RunDirectory
from .spawn import spawn
from .stack import BackOffTimes, ServiceProcess


class ServiceChild:
    """Starts a service process again and again under the same name, log file and pid file."""

    def __init__(self, process: ServiceProcess, directory: RunDirectory, times: BackOffTimes):
        self.process = process
        self.name = process.name
        self.restart_due: Optional[float] = None  # time.monotonic() of a planned restart
        self.ended_in = ""  # the series of trials that ran when it ended; empty: none
        self.back_off = BackOff(times)
        self._directory = directory
        self._log_file = directory.log_of(self.name)
        self._pid_file = directory.pid_file_of(self.name)
        self._popen: Optional[subprocess.Popen] = None
        self._started = 0.0

    def start(self, command: Sequence[str]) -> None:
        with open(self._log_file, "ab") as log:
            self._popen = spawn(command, stdout=log, stderr=log)
        self._started = time.monotonic()
        self.restart_due = None
        identity = ProcessIdentity.of(self._popen.pid)
        if identity:
            record = {**identity.to_json(), "restarts": self.back_off.restarts}
            _if_possible(lambda: write_json(self._pid_file, record))

    def alive(self) -> bool:
        return self._popen is not None and self._popen.poll() is None

    def take_end(self) -> Optional[int]:
        """The return code if it has ended since the last call, else None."""
        if self._popen is None or self._popen.poll() is None:
            return None
        code = self._popen.returncode
        self._popen = None
        self._pid_file.unlink(missing_ok=True)
        return code

    def plan_restart(self, last_end: str) -> float:
        """After an end: returns the wait in seconds."""
        wait_s = self.back_off.crashed(self._ran_s())
        self.restart_due = time.monotonic() + wait_s
        self._record(last_end)
        return wait_s

    def forgets_crashes_in(self) -> Optional[float]:
        """Seconds until its crashes are forgotten, if it goes on running; None if there is nothing to
        forget. To be called again then."""
        if not self.back_off.in_a_row or not self.alive():
            return None
        if self.back_off.runs_well(self._ran_s()):
            self._record("")
            return None
        return self.back_off.time_to_forget(self._ran_s())

    def _ran_s(self) -> float:
        return time.monotonic() - self._started

    def _record(self, last_end: str) -> None:
        record = CrashRecord(self.back_off.restarts, self.back_off.in_a_row,
                             self.back_off.looping, last_end)
        _if_possible(lambda: record.write(self._directory, self.name))

    def signal(self, number: int) -> None:
        if self._popen is not None:
            self._popen.send_signal(number)

    def last_log_lines(self, count: int = 10) -> List[str]:
        return last_lines(self._log_file, count)


def _if_possible(write: Callable[[], None]) -> None:
    """A full disk costs a record, but neither the stack nor the service."""
    with suppress(OSError):
        write()


def last_lines(file: Path, count: int) -> List[str]:
    try:
        return file.read_text(errors="replace").splitlines()[-count:]
    except OSError:
        return []


def how_it_ended(code: int) -> str:
    """A Popen return code in words."""
    if code == -signal.SIGKILL:
        return "was killed (signal 9)"
    if code < 0:
        return f"was ended by signal {-code} ({signal.strsignal(-code) or 'unknown'})"
    return f"ended with exit code {code}"
