"""What can be said of a signal that swings: period, amplitude, likeness to another."""

import cmath
import itertools
import math
from dataclasses import dataclass
from typing import List, Sequence, Tuple


def amplitude(signal: Sequence[float]) -> float:
    """Half of the span between the extremes."""
    return (max(signal) - min(signal)) / 2


def offset(signal: Sequence[float]) -> float:
    """Middle of the extremes: of few periods better than the mean."""
    return (max(signal) + min(signal)) / 2


def correlation(a: Sequence[float], b: Sequence[float]) -> float:
    """Pearson's coefficient; 0 where one of the two does not move."""
    mean_a, mean_b = math.fsum(a) / len(a), math.fsum(b) / len(b)
    product = math.fsum((x - mean_a) * (y - mean_b) for x, y in zip(a, b))
    size = math.sqrt(math.fsum((x - mean_a) ** 2 for x in a) * math.fsum((y - mean_b) ** 2 for y in b))
    return product / size if size > 1e-12 else 0.0


def line_through(x: Sequence[float], y: Sequence[float]) -> Tuple[float, float]:
    """Slope and value at 0 of the least-squares line."""
    mean_x, mean_y = math.fsum(x) / len(x), math.fsum(y) / len(y)
    slope = (math.fsum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) /
             math.fsum((a - mean_x) ** 2 for a in x))
    return slope, mean_y - slope * mean_x


def delayed_correlation(output: Sequence[float], source: Sequence[float], delay: int) -> float:
    """Of the output with the source `delay` samples before."""
    return correlation(output[delay:], source[:len(source) - delay])


@dataclass(frozen=True)
class Orbit:
    """A trajectory about the origin of a plane, sampled once a tick."""

    period_ticks: float  # infinite where it does not turn
    clockwise: bool
    scatter: float  # largest distance of a state from the curve through its neighbours, share of the mean radius
    nearest_return: float  # smallest distance between two states, share of the mean radius

    @property
    def repeats(self) -> bool:
        """Two states are the same but for rounding."""
        return self.nearest_return < 1e-9


def orbit(x: Sequence[float], y: Sequence[float]) -> Orbit:
    """Needs some turns about the origin; at least 30 states."""
    states = [complex(a, b) for a, b in zip(x, y)]
    turns = [cmath.phase(after * before.conjugate()) for before, after in zip(states, states[1:])]
    angles = [0.0, *itertools.accumulate(turns)]
    advance, _ = line_through(range(len(angles)), angles)  # the orbit is no circle: ends alone would mislead
    radius = math.fsum(abs(state) for state in states) / len(states)
    nearest = min(abs(a - b) for i, a in enumerate(states) for b in states[:i])
    if radius < 1e-9:
        return Orbit(math.inf, False, 0.0, 0.0)
    period = abs(2 * math.pi / advance) if abs(advance) > 1e-6 else math.inf
    return Orbit(period, advance < 0, _scatter(states) / radius, nearest / radius)


def _scatter(states: List[complex]) -> float:
    """Radius of each state against the one interpolated between its neighbours in angle.

    A closed curve that is filled leaves almost nothing; an orbit that drifts, or noise, does.
    """
    around = sorted(states, key=cmath.phase)
    worst = 0.0
    for before, state, after in zip(around, around[1:], around[2:]):
        span = cmath.phase(after * before.conjugate())
        share = cmath.phase(state * before.conjugate()) / span if span > 1e-12 else 0.5
        worst = max(worst, abs(abs(state) - (1 - share) * abs(before) - share * abs(after)))
    return worst
