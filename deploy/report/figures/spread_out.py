"""Dots side by side, so that equal ones do not hide each other."""

from typing import List, Sequence


def spread_out(values: Sequence[float], half_width: float) -> List[float]:
    """Sideways shift of each dot in [-half_width, half_width]: by rank, evenly, the same every time."""
    count = len(values)
    if count < 2:
        return [0.0] * count
    # Neighbours in value go to places far apart.
    order = sorted(range(count), key=lambda i: (values[i], i))
    places = [*range(0, count, 2), *range(1, count, 2)] if len(set(values)) > 1 else list(range(count))
    shifts = [0.0] * count
    for rank, i in enumerate(order):
        shifts[i] = half_width * (2 * places[rank] / (count - 1) - 1)
    return shifts
