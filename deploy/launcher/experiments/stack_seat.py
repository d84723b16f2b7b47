"""Trials on a stack of processes of their own, on a DDS domain of its own."""

import os
import sys
from typing import List, Optional

from ..domain_claim import claim_domain
from ..keeper_events import Event, event_line
from ..launch import Checked, Launched, begin
from ..log_files import is_open, log_files
from ..places import Places
from ..running_stack import Kind, end_leftovers
from ..signals import Signals
from ..stack import Pace
from ..trial_lock import TrialLock
from .directory import ExperimentDirectory
from .plan import PlannedTrial
from .seat import Fault
from .worker_process import WorkerProcess

_PATIENCE_S = 5.0


class StackSeat:
    """Keeps its stack from trial to trial; a recorded trial has one of its own, whose logger's file is its
    log."""

    def __init__(self, number: int, places: Places, checked: Checked, directory: ExperimentDirectory,
                 record: bool, signals: Signals):
        self.name = f"stack {number}"
        self._places = places
        self._checked = checked
        self._directory = directory
        self._record = record
        self._signals = signals
        self._log_file = directory.logs / f"worker-{number}.log"
        self._program = str(places.program("scarab-experiment"))
        self._launched: Optional[Launched] = None
        self._lock: Optional[TrialLock] = None
        self._worker: Optional[WorkerProcess] = None
        self._trial: Optional[PlannedTrial] = None

    def give(self, trial: PlannedTrial) -> None:
        self._trial = trial
        if self._launched is None:
            self._launched = begin(self._places, self._checked, claim_domain(None), Pace.LOCKSTEP,
                                   Kind.RUN, self._directory.stacks)
        elif self._worker is not None:
            self._worker.give(trial.line())

    def descriptors(self) -> List[int]:
        found = [self._launched.keeper.descriptor] if self._launched else []
        return found + ([self._worker.descriptor] if self._worker and not self._worker.ended else [])

    def look(self) -> Optional[str]:
        if self._launched is None:
            return None
        for event in self._launched.keeper.new_events():
            self._note(event)
        if self._launched.keeper.ended:
            raise Fault("its stack was stopped, or its keeper has died")
        if self._worker is None:
            return None
        line = self._worker.take_line()
        if line is None and self._worker.ended:
            raise Fault(f"scarab-experiment {self._worker.how_it_ended(_PATIENCE_S)}")
        if line is not None and self._record:
            self._keep_log()
        return line

    def ask_to_end(self) -> None:
        if self._worker is not None:
            self._worker.ask_to_end()
        if self._launched is not None:
            self._launched.keeper.ask_to_stop()

    def clear(self) -> None:
        if self._worker is not None:
            self._worker.end(_PATIENCE_S)
            self._worker = None
        if self._lock is not None:
            self._lock.release()
            self._lock = None
        if self._launched is not None:
            self._launched.keeper.stop(self._signals)
            end_leftovers(self._launched.run.directory)  # of a keeper that was killed
            self._launched = None

    def _note(self, event: Event) -> None:
        """Fault where the stack is of no use any more: the tick master is not restarted within a trial."""
        if event["event"] == "ready":
            self._begin_trials()
            return
        if event["event"] == "failed":
            raise Fault(str(event["text"]))
        master = self._checked.stack.tick_master()
        if event["event"] in ("crashed", "lost") and master and event.get("service") == master.name:
            raise Fault(f"{master.name} {event['text']}")
        line = event_line(event)
        if line:
            print(f"\nscarab: {self.name}: {line}", file=sys.stderr, flush=True)

    def _begin_trials(self) -> None:
        run = self._launched.run
        self._lock = TrialLock.try_take(run.directory.trial_lock)
        if self._lock is None:
            raise Fault("somebody else runs trials on its stack")
        command = [self._program, *run.bus.arguments(), "--expect", run.stack.expected(), "--worker"]
        self._worker = WorkerProcess(command, self._log_file)
        self._worker.give(self._trial.line())

    def _keep_log(self) -> None:
        """It is whole once the logger has been stopped."""
        place = self._launched.run.directory.path
        self._worker.finish(_PATIENCE_S)
        self.clear()
        files = log_files(place)
        if not files or any(map(is_open, files)):
            raise Fault(f"the logger of its stack left no whole log in {place}")
        if len(files) > 1:
            raise Fault(f"the logger of its stack left {len(files)} files in {place}: an experiment's trial is one "
                        "file, so that its logger may not split the log")
        os.replace(files[0], self._directory.log_of(self._trial))
