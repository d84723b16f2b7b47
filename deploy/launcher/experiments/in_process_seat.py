"""Trials with the cores of all services in one process: scarab-sim."""

from pathlib import Path
from typing import List, Optional

from ..places import Places
from .configuration import simulation_arguments
from .directory import ExperimentDirectory
from .plan import PlannedTrial
from .seat import Fault
from .worker_process import WorkerProcess

_PATIENCE_S = 5.0
_CLOSING_PATIENCE_S = 60.0  # of a log


class InProcessSeat:
    """Keeps its process from trial to trial; a recorded trial has one of its own, whose log it is."""

    def __init__(self, number: int, places: Places, directory: ExperimentDirectory, record: bool):
        self.name = f"worker {number}"
        self._directory = directory
        self._record = record
        self._log_file = directory.logs / f"worker-{number}.log"
        self._command = [str(places.program("scarab-sim")), *simulation_arguments(directory.config),
                         "--worker"]
        self._worker: Optional[WorkerProcess] = None
        self._log: Optional[Path] = None

    def give(self, trial: PlannedTrial) -> None:
        if self._worker is None:
            self._worker = WorkerProcess([*self._command, *self._recording(trial)], self._log_file)
        self._worker.give(trial.line())

    def descriptors(self) -> List[int]:
        return [self._worker.descriptor] if self._worker and not self._worker.ended else []

    def look(self) -> Optional[str]:
        if self._worker is None:
            return None
        line = self._worker.take_line()
        if line is None and self._worker.ended:
            raise Fault(f"scarab-sim {self._worker.how_it_ended(_PATIENCE_S)}")
        if line is not None and self._record:
            self._close_log()
        return line

    def ask_to_end(self) -> None:
        if self._worker is not None:
            self._worker.ask_to_end()

    def clear(self) -> None:
        if self._worker is not None:
            self._worker.end(_PATIENCE_S)
            self._worker = None

    def _recording(self, trial: PlannedTrial) -> List[str]:
        if not self._record:
            return []
        self._log = self._directory.log_of(trial)
        self._log.unlink(missing_ok=True)  # of an attempt that came to nothing
        return ["--output", str(self._log)]

    def _close_log(self) -> None:
        """It is whole once its process has ended."""
        code = self._worker.finish(_CLOSING_PATIENCE_S)
        self._worker = None
        if code != 0 or not self._log.is_file():
            raise Fault(f"scarab-sim ended with {code} and left no whole log {self._log.name}")
