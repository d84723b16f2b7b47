"""Hands each trial to whoever is free, and again where it could not be run."""

import sys
import time
from collections import Counter, deque
from typing import Callable, Deque, Dict, List, Optional, Sequence

from ..failure import Failure
from ..signals import Signals
from .journal import Journal
from .plan import PlannedTrial
from .results import ForeignLine, Result, error_of, is_final_error, read_result
from .seat import Fault, Seat

RETRIES = 2
_LOOK_AT_LEAST_EVERY_S = 0.5
# A trial whose answer has not come after this long is as good as dead: 4 s of machine time for a simulated
# second, on top of what a stack may take to start.
_PATIENCE_S = 120.0
_PATIENCE_S_PER_S = 4.0


class Dispatch:
    """Runs the trials on the seats; each result goes to the journal, and then to `listen`."""

    def __init__(self, seats: Sequence[Seat], trials: Sequence[PlannedTrial], journal: Journal,
                 listen: Callable[[Optional[Result]], None], signals: Signals,
                 clock: Callable[[], float] = time.monotonic):
        """`listen` hears None now and then, too."""
        self._clock = clock
        self._seats = seats
        self._waiting: Deque[PlannedTrial] = deque(trials)
        self._journal = journal
        self._listen = listen
        self._signals = signals
        self._running: Dict[str, PlannedTrial] = {}
        self._given_at: Dict[str, float] = {}
        self._faults: Counter = Counter()

    def run(self) -> None:
        """Until every trial has a result. Failure where one cannot be run, Interrupted on a request to stop;
        nothing that was started is left."""
        try:
            while self._waiting or self._running:
                self._signals.raise_if_stop_requested()
                for seat in self._seats:
                    self._attend(seat)
                self._journal.sync_if_due()
                if self._running:
                    self._signals.wait(_LOOK_AT_LEAST_EVERY_S, self._descriptors())
                    self._listen(None)
        finally:
            self._journal.sync()
            for seat in self._seats:
                seat.ask_to_end()
            for seat in self._seats:
                seat.clear()

    def _attend(self, seat: Seat) -> None:
        try:
            self._take_answer(seat)
            if seat.name not in self._running and self._waiting:
                trial = self._waiting.popleft()
                self._running[seat.name] = trial
                self._given_at[seat.name] = self._clock()
                seat.give(trial)
        except Fault as fault:
            self._try_again(seat, str(fault))

    def _take_answer(self, seat: Seat) -> None:
        trial = self._running.get(seat.name)
        line = seat.look()
        if line is None or trial is None:
            self._check_patience(seat, trial)
            return
        said = error_of(line)
        if said is not None:
            if is_final_error(line):
                raise Failure(f"{seat.name} refuses its trials: {said}")
            raise Fault(said)
        try:
            result = read_result(line, {trial.index: trial})
        except ForeignLine as error:
            raise Fault(f"its answer {error}") from None
        del self._running[seat.name]
        self._journal.add(line)
        self._listen(result)

    def _check_patience(self, seat: Seat, trial: Optional[PlannedTrial]) -> None:
        if trial is None:
            return
        patience_s = _PATIENCE_S + _PATIENCE_S_PER_S * trial.time_limit_s
        if self._clock() - self._given_at[seat.name] > patience_s:
            raise Fault(f"there is no answer after {patience_s:.0f} s")

    def _try_again(self, seat: Seat, reason: str) -> None:
        """Failure after the last try, or for a seat that fails without a trial."""
        seat.clear()
        trial = self._running.pop(seat.name, None)
        if trial is None:  # between two trials: the next one will start it anew
            return
        self._faults[trial.index] += 1
        if self._faults[trial.index] > RETRIES:
            raise Failure(f"trial {trial.index} could not be run in {RETRIES + 1} attempts; the last time on "
                          f"{seat.name}: {reason}")
        print(f"\nscarab: {seat.name}: {reason}; it is started anew, and trial {trial.index} again (retry "
              f"{self._faults[trial.index]} of {RETRIES})", file=sys.stderr, flush=True)
        self._waiting.appendleft(trial)

    def _descriptors(self) -> List[int]:
        return [descriptor for seat in self._seats for descriptor in seat.descriptors()]
