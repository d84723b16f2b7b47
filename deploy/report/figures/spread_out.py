"""Dots side by side, so that equal ones do not hide each other."""

from typing import List


def spread_out(count: int, half_width: float) -> List[float]:
    """Sideways shift of each dot in [-half_width, half_width], evenly: in the order of the seeds."""
    if count < 2:
        return [0.0] * count
    return [half_width * (2 * i / (count - 1) - 1) for i in range(count)]
