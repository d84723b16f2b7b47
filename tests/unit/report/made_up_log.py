"""Logs for fake_bin/scarab-log: a network that does what docs/equations.md says, behaviours, and walks."""

import json
import math
from pathlib import Path
from typing import Dict, List, Sequence, Tuple

from made_up import Row

FAKE_BIN = Path(__file__).resolve().parent / "fake_bin"
INPUTS = {"table-forward": (1, 1, 0, 0), "table-backward": (0, 1, 0, 0), "table-soft-push": (1, -1, 1, 1),
          "table-boxing": (-1, -1, 1, 0), "table-hard-push": (1, 0, 0, -0.3)}
Table = Dict[str, List[object]]


def write_log(file: Path, trial: Row, topics: Dict[str, Table]) -> None:
    """A log with one trial, which is number 1 in it."""
    about = {"header.trial": [1], "strategy": [trial["strategy"]], "obstacle_height_m": [trial["height_m"]],
             **{name: [trial[name]] for name in ("seed", "friction_scale", "object_mass_kg", "object_diameter_m")}}
    file.write_text(json.dumps({"scarab/trial": about, **{f"scarab/{name}": t for name, t in topics.items()}}))


def neural_activity(strategy: str, ticks: int = 120) -> Table:
    """The settled network with the row of Table 1 that the strategy holds: what the figures look at."""
    i1, i2, i3, i4 = INPUTS[strategy]
    swap = (i1, i2) in ((1, -1), (-1, -1), (1, 0))
    q = ((i1**2 - i2**2) ** 2 + i1 * i2 * (i2 + i1) / 2) ** 2
    c = [(0.1, 0.1)]
    for _ in range(ticks + 200):
        a, b = c[-1]
        c.append((math.tanh(1.4 * a + 0.7 * b), math.tanh(-0.7 * a + 1.4 * b)))
    c1 = [pair[0] for pair in c]
    p13 = [(-0.45 if swap else 0.45) * value / 0.94 for value in [0.0] * 4 + c1[:-4]]
    v2 = [0.0] + [math.tanh(2 * q * a + (1 - q) * p + 0.02 * q) for a, p in zip(c1, p13)]
    v7 = [math.tanh(math.tanh(1 - 0.57 * i3) * value) for value in v2]
    columns = {"cpg[0]": c1, "cpg[1]": [pair[1] for pair in c], "psn1[12]": p13, "psn1[13]": [-p for p in p13],
               "vrn1[1]": v2, "vrn1[6]": v7, "vrn2[6]": v7}
    for module in (2, 3, 4):
        source = c1 if module == 2 else p13
        columns[f"psn{module}[12]"] = [0.5 * value for value in [0.0] * 4 + source[:-4]]
        columns[f"psn{module}[13]"] = [-value for value in columns[f"psn{module}[12]"]]
    settled = {name: values[200:200 + ticks] for name, values in columns.items()}
    return {"header.sim_time_ns": _times(ticks, 10), **{f"input[{i}]": [value] * ticks
                                                        for i, value in enumerate((i1, i2, i3, i4))}, **settled}


def transport(behaviours: Sequence[Tuple[str, str, int]]) -> Dict[str, Table]:
    """Behaviours with their ticks; BS is above its threshold but in the approach, AS below in mode 2 alone."""
    rows = [(state, mode) for state, mode, count in behaviours for _ in range(count)]
    times = _times(len(rows), 10)
    return {
        "behaviour": {
            "header.sim_time_ns": times, "mode": [f"MODE_{mode}" for _, mode in rows],
            "state": [f"BEHAVIOUR_{state}" for state, _ in rows],
            "bs_rad": [0.05 if state == "APPROACH" else 0.2 for state, _ in rows],
            "bs_threshold_rad": [0.15] * len(rows),
            "as_rad": [0.90 if state == "MODE_2" else 1.0 for state, _ in rows],
            "as_threshold_rad": [0.95] * len(rows)},
        "robot_state": {"header.sim_time_ns": times, **{
            f"position_rad[{joint}]": [0.3 * math.sin(0.43 * i + joint) for i in range(len(rows))]
            for joint in range(19)}}}


def walk(direction: float, turn_rad: float, samples: int = 60) -> Table:
    """3 m along the first heading (direction 1) or against it (-1), turning evenly."""
    yaw = [turn_rad * i / (samples - 1) for i in range(samples)]
    return {"header.sim_time_ns": _times(samples, 2),
            "trunk.position_m[0]": [direction * 3.0 * i / (samples - 1) for i in range(samples)],
            "trunk.position_m[1]": [0.01 * i / samples for i in range(samples)],
            "trunk.orientation_wxyz[0]": [math.cos(angle / 2) for angle in yaw],
            "trunk.orientation_wxyz[1]": [0.0] * samples, "trunk.orientation_wxyz[2]": [0.0] * samples,
            "trunk.orientation_wxyz[3]": [math.sin(angle / 2) for angle in yaw]}


def _times(count: int, per_second: int) -> List[object]:
    return [i * 1_000_000_000 // per_second for i in range(count)]
