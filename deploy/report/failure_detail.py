"""Why trials failed: how often for which reason, and the quantity that goes with it."""

import math
from typing import Iterable, List

from .cells import Cell
from .intervals import median
from .trial import Trial, failure_kind


def why_failed(cells: Iterable[Cell]) -> str:
    """The most frequent kind first; empty where all succeeded."""
    failed = [trial for cell in cells for trial in cell.trials if not trial.success]
    kinds: dict = {}
    for trial in failed:
        kinds.setdefault(failure_kind(trial.reason), []).append(trial)
    ordered = sorted(kinds.items(), key=lambda item: (-len(item[1]), item[0]))
    return ", ".join(f"{len(trials)} × {kind}{_detail(kind, trials)}" for kind, trials in ordered)


def _detail(kind: str, trials: List[Trial]) -> str:
    if trials[0].asked.goal not in ("travel", "across"):
        return ""
    if kind == "time limit":
        parts = [f"the object {median([trial.object_travel_m for trial in trials]):.2f} m on its way"]
        if any("+" in trial.asked.strategy for trial in trials):
            parts.append(f"{sum(trial.mode2_s is not None for trial in trials)} of them in mode 2")
        return f" ({', '.join(parts)})"
    if kind == "object lost sideways":
        turned = median([abs(math.degrees(trial.heading_rad)) for trial in trials])
        after = median([trial.time_s for trial in trials])
        return f" (after {after:.0f} s, the robot turned by {turned:.0f}°)"
    return ""
