"""How long the trials that are left will take."""

from collections import defaultdict
from typing import Callable, Dict, Iterable, Optional, Sequence, Tuple

from .plan import PlannedTrial
from .results import Result


class Estimate:
    """A trial is expected to last, in simulated time, as long as those of its cell on average; one of a cell
    of which nothing is known, as those of its strategy, else as all. How fast simulated time goes is
    measured."""

    def __init__(self, done_before: Iterable[Result], left: Sequence[PlannedTrial],
                 clock: Callable[[], float]):
        self._left = {trial.index: trial for trial in left}
        self._lasted: Dict[object, Tuple[int, float]] = defaultdict(lambda: (0, 0.0))  # trials, s
        self._clock = clock
        self._began = clock()
        self.simulated_s = 0.0  # in this session
        for result in done_before:
            self._note(result)

    def add(self, result: Result) -> None:
        """A trial has been done now."""
        self._left.pop(result.trial.index, None)
        self.simulated_s += result.time_s
        self._note(result)

    @property
    def elapsed_s(self) -> float:
        return self._clock() - self._began

    @property
    def speed(self) -> Optional[float]:
        """Simulated seconds a second; None before anything is known."""
        return self.simulated_s / self.elapsed_s if self.simulated_s and self.elapsed_s > 0 else None

    def left_s(self) -> Optional[float]:
        """None before anything is known."""
        speed = self.speed
        return sum(map(self._expected_s, self._left.values())) / speed if speed else None

    def _note(self, result: Result) -> None:
        for key in _keys(result.trial):
            count, sum_s = self._lasted[key]
            self._lasted[key] = (count + 1, sum_s + result.time_s)

    def _expected_s(self, trial: PlannedTrial) -> float:
        for key in _keys(trial):
            if key in self._lasted:
                count, sum_s = self._lasted[key]
                return sum_s / count
        return trial.time_limit_s


def _keys(trial: PlannedTrial) -> Sequence[object]:
    """From the nearest relatives of a trial to the farthest."""
    return trial.cell(), trial.strategy, None


def duration(seconds: float) -> str:
    """Such as 1:05, or 2:03:04."""
    whole = round(seconds)
    hours, minutes = divmod(whole // 60, 60)
    return f"{hours}:{minutes:02}:{whole % 60:02}" if hours else f"{minutes}:{whole % 60:02}"
