"""Directories of experiments as the launcher leaves them, with results that a test chooses."""

import csv
import json
import sys
from pathlib import Path
from typing import Callable, Dict, List, Sequence

SOURCE_ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(SOURCE_ROOT / "deploy"))

from report.trial import CONDITIONS, OUTCOME  # noqa: E402

CONFIGURATION = "0badcafe"
Row = Dict[str, object]

LOST = "the object was lost: 0.26 m sideways of the trunk, limit 0.25 m"
TOO_SLOW = "time limit of 60.0 s: the object travelled 0.713 m"


def trial(index: int, strategy: str, seed: int, **changes: object) -> Row:
    """A planned trial; the rest is that of the paper's experiments."""
    values = {"index": index, "strategy": strategy, "goal": "across", "height_m": 0.1, "distance_m": 1.46,
              "time_limit_s": 60.0, "seed": seed, "perturb_position_m": 0.02, "perturb_yaw_rad": 0.05235987755982988,
              "perturb_friction": 0.1, "perturb_cpg_phase": True, "friction_scale": 1.0, "object_mass_kg": 0.0,
              "object_diameter_m": 0.0}
    return {**values, **changes}


def planned(cells: Sequence[Row], trials: int, first_seed: int = 1000001) -> List[Row]:
    """The same seeds for every cell."""
    return [trial(i * trials + k + 1, seed=first_seed + k, **cell) for i, cell in enumerate(cells)
            for k in range(trials)]


def outcome(success: bool = True, time_s: float = 20.0, reason: str = "across", **changes: object) -> Row:
    values = {"success": success, "time_s": time_s, "reason": reason, "object_travel_m": 1.5, "object_sideways_m": 0.02,
              "trunk_travel_m": 1.4, "heading_rad": 0.01, "heading_max_rad": 0.05, "climb_s": 2.0, "mode1_s": 2.6,
              "mode2_s": None}
    return {**values, **changes}


def write_plan(directory: Path, trials: Sequence[Row], figure: str, **changes: object) -> None:
    directory.mkdir(parents=True, exist_ok=True)
    plan = {"name": directory.name, "title": f"Made up: {figure}", "figure": figure, "paper_figure": "Fig. 0",
            "paper": ["What the paper says."], "notes": [], "command": f"deploy/scarab experiment {figure} --inproc",
            "version": "0.4.0", "configuration": CONFIGURATION, "trials": list(trials)}
    (directory / "plan.json").write_text(json.dumps({**plan, **changes}))


def write_results(directory: Path, trials: Sequence[Row], run: Callable[[Row], Row]) -> None:
    with open(directory / "results.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow([*CONDITIONS, *OUTCOME, "configuration"])
        for asked in trials:
            row = {**asked, **run(asked)}
            table.writerow([*(_text(row[name]) for name in (*CONDITIONS, *OUTCOME)), CONFIGURATION])


def _text(value: object) -> object:
    return "" if value is None else int(value) if isinstance(value, bool) else value
