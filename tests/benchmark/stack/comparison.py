"""The median of ratios, and how sure it is."""

import math
import statistics
from typing import List, Tuple

SURE = 0.95
FEWEST = 6  # all of six on one side of the median: 2 / 2^6 = 3 %


def percent(share: float) -> str:
    return f"{100 * share:.1f} %"


def interval_ranks(count: int) -> Tuple[int, int]:
    """Of `count` sorted values the indices of two between which the true median lies with at least
    SURE, whatever the distribution: each value is below it with probability 1/2, so that the number
    of those below is binomial. All of them when they are too few."""
    below, tail = 0, 0.0
    while below < count // 2:
        tail += math.comb(count, below) / 2.0**count
        if 2 * tail > 1 - SURE:
            break
        below += 1
    first = max(below - 1, 0)
    return first, count - 1 - first


class Ratios:
    """Of neighbours: what both had in common is gone from them."""

    def __init__(self, ratios: List[float]):
        self._sorted = sorted(ratios)
        low, high = interval_ranks(len(ratios))
        self.low, self.high = self._sorted[low], self._sorted[high]
        self.median = statistics.median(ratios)

    def quartile(self, number: int) -> float:
        return self._sorted[(len(self._sorted) - 1) * number // 4]

    def judge(self, aim: float) -> str:
        """Whether the median is at least `aim`."""
        if len(self._sorted) < FEWEST:
            return "too few pairs to say"
        if self.low >= aim:
            return "met"
        return "not met" if self.high < aim else "not decided; more --repeats, or a quieter machine"

    def __str__(self) -> str:
        if len(self._sorted) < FEWEST:
            return f"{self.median:7.3f}   (median of {len(self._sorted)})"
        return (f"{self.median:7.3f}   (95 %: {self.low:.3f} to {self.high:.3f}; quartiles "
                f"{self.quartile(1):.3f} and {self.quartile(3):.3f} of {len(self._sorted)})")
