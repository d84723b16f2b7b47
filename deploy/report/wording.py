"""Numbers and conditions as a person reads them."""

import math
from typing import Iterable, List, Optional, Sequence

from .cells import Cell, pooled
from .intervals import deviation, mean
from .trial import CellKey, Conditions


def percent(share: float) -> str:
    return f"{100 * share:.0f} %"


def centimetres(height_m: float) -> str:
    return f"{100 * height_m:g}"


def shown_height(height_m: float) -> str:
    return f"{centimetres(height_m)} cm" if height_m else "flat"


def seconds(value: Optional[float]) -> str:
    return "none" if value is None else f"{value:.1f} s"


def spread(times_s: Sequence[float]) -> str:
    """Mean and standard deviation."""
    if not times_s:
        return "none arrived"
    sd = deviation(times_s)
    return f"{mean(times_s):.1f} s" + (f" ± {sd:.1f} s" if sd is not None else "")


def interval(cell: Cell) -> str:
    low, high = cell.interval
    return f"{100 * low:.0f} to {100 * high:.0f} %"


def counted(cell: Cell) -> str:
    return f"{cell.count} ({interval(cell)})"


def failures(cells: Iterable[Cell]) -> str:
    """Kinds of failure with their counts; empty where all succeeded."""
    found = list(cells)
    kinds = pooled(found).failures if found else {}
    return ", ".join(f"{count} × {kind}" for kind, count in kinds.items())


def conditions(key: CellKey) -> str:
    words: List[str] = [key.strategy, shown_height(key.height_m)]
    if key.object_mass_kg:
        words.append(f"{key.object_mass_kg:g} kg")
    if key.object_diameter_m:
        words.append(f"{centimetres(key.object_diameter_m)} cm diameter")
    if key.friction_scale != 1:
        words.append(f"friction × {key.friction_scale:g}")
    return ", ".join(words)


def perturbation(trials: Sequence[Conditions]) -> str:
    """What differs from trial to trial of a cell."""
    first = trials[0]
    parts = []
    if first.perturb_position_m:
        parts.append(f"start ±{100 * first.perturb_position_m:g} cm")
    if first.perturb_yaw_rad:
        parts.append(f"±{round(math.degrees(first.perturb_yaw_rad), 3):g}°")
    if first.perturb_friction:
        parts.append(f"friction ±{100 * first.perturb_friction:g} %")
    if first.perturb_cpg_phase:
        parts.append("CPG phase uniform")
    return ", ".join(parts) if parts else "no perturbation"


def seeds(trials: Sequence[Conditions]) -> str:
    numbers = sorted({trial.seed for trial in trials})
    if len(numbers) == 1:
        return f"seed {numbers[0]}"
    if numbers[-1] - numbers[0] == len(numbers) - 1:
        return f"seeds {numbers[0]} to {numbers[-1]}"
    return f"{len(numbers)} seeds from {numbers[0]} to {numbers[-1]}"
