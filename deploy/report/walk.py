"""Where the trunk of a walking robot went, from the log of a trial (topic scarab/world_state)."""

import math
from dataclasses import dataclass
from typing import List

from .experiment import Experiment
from .trial import Conditions

_FIELDS = ("trunk.position_m", "trunk.orientation_wxyz")


@dataclass(frozen=True)
class Walk:
    """In the frame of the start: x along the first heading, y to the left; metres and radians."""

    x_m: List[float]
    y_m: List[float]
    heading_rad: List[float]  # against the first one, unwrapped

    @property
    def distance_m(self) -> List[float]:
        """From the start, as the crow flies."""
        return [math.hypot(x, y) for x, y in zip(self.x_m, self.y_m)]


def read_walk(experiment: Experiment, trial: Conditions) -> Walk:
    """ReportError where the trial has no log."""
    table = experiment.logs.samples(trial, "world_state", _FIELDS)
    x, y = ([float(value) for value in table[f"trunk.position_m[{axis}]"]] for axis in (0, 1))
    quaternions = zip(*([float(value) for value in table[f"trunk.orientation_wxyz[{i}]"]] for i in range(4)))
    yaw = [math.atan2(2 * (w * c + a * b), 1 - 2 * (b * b + c * c)) for w, a, b, c in quaternions]
    heading = [0.0]
    for before, after in zip(yaw, yaw[1:]):
        heading.append(heading[-1] + math.remainder(after - before, 2 * math.pi))
    cos, sin = math.cos(yaw[0]), math.sin(yaw[0])
    from_start = [(a - x[0], b - y[0]) for a, b in zip(x, y)]
    return Walk([cos * a + sin * b for a, b in from_start], [cos * b - sin * a for a, b in from_start], heading)
