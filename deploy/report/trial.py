"""One trial: what was asked for, and what came out."""

from dataclasses import dataclass
from typing import Optional, Tuple

CONDITIONS = ("index", "strategy", "goal", "height_m", "distance_m", "time_limit_s", "seed",
              "perturb_position_m", "perturb_yaw_rad", "perturb_friction", "perturb_cpg_phase",
              "friction_scale", "object_mass_kg", "object_diameter_m")
OUTCOME = ("success", "time_s", "reason", "object_travel_m", "object_sideways_m", "trunk_travel_m",
           "heading_rad", "heading_max_rad", "climb_s", "mode1_s", "mode2_s")


@dataclass(frozen=True)
class Conditions:
    """What was asked for; the keys of a trial line."""

    index: int
    strategy: str
    goal: str
    height_m: float  # 0: no obstacle
    distance_m: float
    time_limit_s: float
    seed: int
    perturb_position_m: float
    perturb_yaw_rad: float
    perturb_friction: float
    perturb_cpg_phase: bool
    friction_scale: float
    object_mass_kg: float  # 0: as in the plant's configuration
    object_diameter_m: float  # 0: as in the plant's configuration

    @property
    def cell(self) -> "CellKey":
        return CellKey(self.strategy, self.height_m, self.object_mass_kg, self.object_diameter_m,
                       self.friction_scale)


@dataclass(frozen=True)
class CellKey:
    """What trials of one cell have in common; they differ in their seeds."""

    strategy: str
    height_m: float
    object_mass_kg: float
    object_diameter_m: float
    friction_scale: float


@dataclass(frozen=True)
class Trial:
    """A row of results.csv."""

    asked: Conditions
    success: bool
    time_s: float  # to the success, or to the failure
    reason: str
    object_travel_m: float
    object_sideways_m: float
    trunk_travel_m: float
    heading_rad: float
    heading_max_rad: float
    climb_s: Optional[float]  # when the behaviour began; None: never
    mode1_s: Optional[float]
    mode2_s: Optional[float]
    configuration: str

    @property
    def behaviours_s(self) -> Tuple[Optional[float], Optional[float], Optional[float]]:
        return self.climb_s, self.mode1_s, self.mode2_s


def failure_kind(reason: str) -> str:
    """The referee's reason without its numbers, so that failures can be counted."""
    for words, kind in (("sideways", "object lost sideways"), ("object was lost", "object lost along the path"),
                        ("overturned", "robot overturned"), ("time limit", "time limit")):
        if words in reason:
            return kind
    return reason.split(":")[0].strip() or "no reason given"


def is_loss(trial: Trial) -> bool:
    """The robot lost the object or the direction, or fell; not: it was merely too slow."""
    return not trial.success and failure_kind(trial.reason) != "time limit"
