"""A small experiment of each kind, with logs where its figure is drawn from them."""

import math
from pathlib import Path
from typing import Dict, List

from made_up import LOST, TOO_SLOW, Row, outcome, planned, trial, write_plan, write_results
from made_up_log import INPUTS, neural_activity, transport, walk, write_log

SIX = ("soft", "boxing", "stationary", "soft+hard", "boxing+hard", "stationary+hard")
BEHAVIOURS = (("APPROACH", "BACKWARD", 20), ("CLIMB", "BACKWARD", 6), ("MODE_1", "SOFT_PUSH", 60),
              ("MODE_2", "HARD_PUSH", 40), ("DONE", "STOP", 1))


def plans() -> Dict[str, List[Row]]:
    """Kind -> its planned trials."""
    rows = [trial(i, strategy, 1, goal="none", height_m=0.0) for i, strategy in enumerate(INPUTS)]
    return {
        "cpg": rows[1:2], "psn": rows, "vrn": rows,
        "transport_speed": planned([{"strategy": mode, "goal": "travel", "height_m": 0.0}
                                    for mode in ("soft", "hard", "boxing", "stationary")], 4),
        "obstacle": planned([{"strategy": name, "height_m": height} for name in SIX for height in (0.05, 0.1)], 3),
        "sequence": planned([{"strategy": "soft+hard", "height_m": 0.05}], 1),
        "walking": planned([{"strategy": f"walk-{way}", "goal": "walk", "height_m": 0.0}
                            for way in ("forward", "backward")], 2),
        "beyond": planned([{"strategy": "soft+hard", "height_m": height} for height in (0.0, 0.12, 0.14)], 5, 2000001),
        "robustness": planned([{"strategy": "soft+hard", "object_mass_kg": mass, "object_diameter_m": 0.18,
                                "friction_scale": scale} for mass in (1.0, 2.0) for scale in (0.75, 1.0)], 2)}


def run(asked: Row) -> Row:
    """Some of everything: hard is lost, every fourth seed is too slow above 8 cm."""
    number = asked["seed"] % 1000
    if asked["strategy"] == "hard":
        return outcome(False, 12.0 + number, LOST)
    if asked["height_m"] > 0.08 and number % 4 == 0:
        return outcome(False, 60.0, TOO_SLOW)
    return outcome(True, 10.0 + 3 * SIX.index(asked["strategy"]) + 0.7 * number if asked["strategy"] in SIX else 15.0,
                   mode1_s=2.6, mode2_s=8.6, heading_max_rad=math.radians(4 * number), heading_rad=-0.05)


def write_experiment(directory: Path, kind: str, done: "int | None" = None) -> None:
    """All of it, or the first `done` trials."""
    trials = plans()[kind]
    write_plan(directory, trials, kind)
    write_results(directory, trials[:done], run)
    for asked in trials[:done]:
        topics = _topics(asked)
        if topics:
            write_log(directory / f"trial-{asked['index']}.mcap", asked, topics)


def _topics(asked: Row) -> dict:
    if asked["strategy"] in INPUTS:
        return {"neural_activity": neural_activity(asked["strategy"])}
    if asked["strategy"].startswith("walk-"):
        way = 1.0 if asked["strategy"] == "walk-forward" else -1.0
        return {"world_state": walk(way, 0.03 * (asked["seed"] % 10))}
    return transport(BEHAVIOURS) if asked["height_m"] == 0.05 and asked["strategy"] == "soft+hard" else {}
