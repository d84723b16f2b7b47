"""Walks out of the samples of scarab/world_state: where the trunk went and where feet stood."""

import csv
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, Iterable, List, Tuple

LEGS = ("L0", "L1", "L2", "R0", "R1", "R2")  # slots of idl/scarab/header.idl
_GROUND, _FOOT = ("SOLID_GROUND", "0"), ("SOLID_FOOT", "7")
_POSE = ("header.trial", "header.sim_time_ns", "trunk.position_m[0]", "trunk.position_m[1]",
         *(f"trunk.orientation_wxyz[{i}]" for i in range(4)), "contacts.length")


class WalkTableError(Exception):
    """A table without the columns or rows of a walk."""


@dataclass(frozen=True)
class Sample:
    """One instant: the trunk, and where the feet on the ground touch it, by leg slot."""

    time_s: float
    place_m: Tuple[float, float]
    yaw_rad: float
    tilt_rad: float
    feet_m: Dict[int, Tuple[float, float]]


@dataclass
class Walk:
    """One trial, in the frame of its start: x along the first heading, y to the left."""

    trial: int
    samples: List[Sample] = field(default_factory=list)

    @property
    def time_s(self) -> float:
        return self.samples[-1].time_s - self.samples[0].time_s

    @property
    def speed_m_s(self) -> float:
        return self.samples[-1].place_m[0] / self.time_s if self.time_s else 0.0

    @property
    def sideways_m(self) -> float:
        return self.samples[-1].place_m[1]

    @property
    def turned_deg(self) -> float:
        turned = 0.0
        for before, after in zip(self.samples, self.samples[1:]):
            turned += math.remainder(after.yaw_rad - before.yaw_rad, 2 * math.pi)
        return math.degrees(turned)

    @property
    def tilt_deg(self) -> float:
        return math.degrees(max(sample.tilt_rad for sample in self.samples))


def read_walks(file: Path) -> List[Walk]:
    """One walk for each trial of the table."""
    with open(file, newline="") as source:
        reader = csv.DictReader(source)
        missing = [name for name in _POSE if name not in (reader.fieldnames or [])]
        if missing:
            raise WalkTableError(f"{file} has no column {', '.join(missing)}")
        try:
            walks = _walks(reader)
        except (TypeError, ValueError, KeyError) as error:
            raise WalkTableError(f"{file}: {error} is no number or no column; "
                                 "were --elements enough for all contacts?") from None
    if not walks:
        raise WalkTableError(f"{file} has no rows")
    return walks


def _walks(rows: Iterable[Dict[str, str]]) -> List[Walk]:
    walks: Dict[int, Walk] = {}
    for row in rows:
        trial = int(row["header.trial"])
        walks.setdefault(trial, Walk(trial)).samples.append(_sample(row))
    for walk in walks.values():
        walk.samples.sort(key=lambda sample: sample.time_s)
        origin, yaw = walk.samples[0].place_m, walk.samples[0].yaw_rad
        walk.samples = [_seen_from(origin, yaw, sample) for sample in walk.samples]
    return list(walks.values())


def _sample(row: Dict[str, str]) -> Sample:
    w, x, y, z = (float(row[f"trunk.orientation_wxyz[{i}]"]) for i in range(4))
    feet = {}
    for i in range(int(row["contacts.length"])):
        contact = f"contacts[{i}]."
        if row[contact + "solid_a"] in _GROUND and row[contact + "solid_b"] in _FOOT:
            feet[int(row[contact + "leg_b"])] = (float(row[contact + "point_m[0]"]),
                                                 float(row[contact + "point_m[1]"]))
    return Sample(
        time_s=int(row["header.sim_time_ns"]) * 1e-9,
        place_m=(float(row["trunk.position_m[0]"]), float(row["trunk.position_m[1]"])),
        yaw_rad=math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
        tilt_rad=math.acos(max(-1.0, min(1.0, 1 - 2 * (x * x + y * y)))),
        feet_m=feet)


def _seen_from(origin: Tuple[float, float], yaw: float, sample: Sample) -> Sample:
    def turned(point: Tuple[float, float]) -> Tuple[float, float]:
        x, y = point[0] - origin[0], point[1] - origin[1]
        return (math.cos(yaw) * x + math.sin(yaw) * y, math.cos(yaw) * y - math.sin(yaw) * x)

    return Sample(sample.time_s, turned(sample.place_m), sample.yaw_rad - yaw, sample.tilt_rad,
                  {leg: turned(point) for leg, point in sample.feet_m.items()})
