"""How far counts and times of a few trials can be trusted."""

import math
import statistics
from typing import Optional, Sequence, Tuple

_Z_95 = 1.959963984540054  # two-sided 95 % of the normal distribution


def wilson(successes: int, n: int) -> Tuple[float, float]:
    """Wilson's 95 % score interval of a share (E. B. Wilson, JASA 22, 1927); (0, 1) for no trial."""
    if n == 0:
        return 0.0, 1.0
    share, z2 = successes / n, _Z_95**2
    middle = (share + z2 / (2 * n)) / (1 + z2 / n)
    half = _Z_95 / (1 + z2 / n) * math.sqrt(share * (1 - share) / n + z2 / (4 * n * n))
    # At 0 and n of n one end is 0 or 1 exactly; rounding must not miss it.
    return (0.0 if successes == 0 else middle - half), (1.0 if successes == n else middle + half)


def mean(values: Sequence[float]) -> Optional[float]:
    return statistics.fmean(values) if values else None


def deviation(values: Sequence[float]) -> Optional[float]:
    """Sample standard deviation; None for less than two values."""
    return statistics.stdev(values) if len(values) > 1 else None


def median(values: Sequence[float]) -> Optional[float]:
    return statistics.median(values) if values else None
