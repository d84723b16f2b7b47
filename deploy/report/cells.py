"""Trials of the same conditions, which differ in their seeds alone."""

from collections import Counter
from dataclasses import dataclass
from typing import Dict, Iterable, List, Tuple

from .intervals import deviation, mean, median, wilson
from .trial import CellKey, Trial, failure_kind


@dataclass(frozen=True)
class Cell:
    """One cell of the plan's grid; `planned` of its trials were asked for, len(trials) have been run."""

    key: CellKey
    planned: int
    trials: List[Trial]

    @property
    def n(self) -> int:
        return len(self.trials)

    @property
    def successes(self) -> int:
        return sum(trial.success for trial in self.trials)

    @property
    def share(self) -> float:
        return self.successes / self.n if self.n else 0.0

    @property
    def interval(self) -> Tuple[float, float]:
        return wilson(self.successes, self.n)

    @property
    def times_s(self) -> List[float]:
        """Of the successes."""
        return [trial.time_s for trial in self.trials if trial.success]

    @property
    def count(self) -> str:
        return f"{self.successes}/{self.n}"

    @property
    def failures(self) -> Dict[str, int]:
        """Kinds of failure, the most frequent first."""
        kinds = Counter(failure_kind(trial.reason) for trial in self.trials if not trial.success)
        return dict(sorted(kinds.items(), key=lambda item: (-item[1], item[0])))

    def document(self) -> Dict[str, object]:
        """For summary.json."""
        low, high = self.interval
        return {**vars(self.key), "planned": self.planned, "n": self.n, "successes": self.successes,
                "share": self.share if self.n else None, "wilson_95": [low, high],
                "mean_s": mean(self.times_s), "sd_s": deviation(self.times_s),
                "median_s": median(self.times_s), "failures": self.failures}


def pooled(cells: Iterable[Cell]) -> Cell:
    """Several cells as one; its key is the first one's."""
    found = list(cells)
    return Cell(found[0].key, sum(cell.planned for cell in found),
                [trial for cell in found for trial in cell.trials])
