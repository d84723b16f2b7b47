#!/usr/bin/python3
"""How far apart the signals of an obstacle's trigger are while the object rolls and once it is blocked."""

import argparse
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Dict, Iterator, List, NamedTuple, Optional, Tuple

import yaml

import triggers

ARM_TICKS = 30        # config/supervisor: not before so many ticks of mode 1
CONFIRM_TICKS = 3     # consecutive ticks that a switch needs
REACH_S = 4.0         # after the wall: later, a switch is late
NEVER = {"front_angle": {"as": {"drop_rad": 100.0}},  # thresholds that nothing reaches: mode 1 goes on
         "supply_current": {"supply_current": {"rise_a": 1000.0}},
         "foot_force": {"foot_force": {"rise_n": 1000.0}}}

_HELP = """Each trial stays in mode 1. What counts is a value that lasts for 3 ticks, as a switch needs it, from 3 s of mode 1
on: per trial the nearest to a switch while the object rolls freely, and the farthest beyond that is reached within 4 s of
the object's hitting the wall. Between the worst of all trials lies the room for a threshold.

example:
  tests/benchmark/sensors/margins.py --bin build/release/bin --trials 20 --trigger supply_current
"""


class Margins(NamedTuple):
    free: List[float]     # of each trial
    blocked: List[float]


def never_switching(folder: Path, supervisor: Path, strategy: str, trigger: str) -> Path:
    path = folder / "supervisor.yaml"
    changed = {"extends": str(supervisor.resolve()), **NEVER[trigger],
               "strategies": {strategy: {"obstacle": [trigger]}}}
    path.write_text(yaml.safe_dump(changed, sort_keys=False), encoding="utf-8")
    return path


def lasting(values: List[float]) -> List[float]:
    """The least of each tick and the two before it."""
    return [min(values[i - CONFIRM_TICKS + 1:i + 1]) for i in range(CONFIRM_TICKS - 1, len(values))]


def in_mode_1(options: argparse.Namespace, log: Path, sign: float) -> Iterator[Tuple[str, float, float]]:
    """Trial, time and lasting value of each tick of an armed mode 1; larger is nearer to a switch."""
    run: List[Tuple[float, float]] = []
    trial = ""
    for row in triggers.table(options, log, "scarab/behaviour", "state", "trigger_value"):
        if row["state"] != "BEHAVIOUR_MODE_1" or row["header.trial"] != trial:
            run, trial = [], row["header.trial"]
        if row["state"] != "BEHAVIOUR_MODE_1":
            continue
        run.append((int(row["header.sim_time_ns"]) * 1e-9, sign * float(row["trigger_value"])))
        if len(run) >= ARM_TICKS + CONFIRM_TICKS:
            yield trial, run[-1][0], lasting([value for _, value in run[-CONFIRM_TICKS:]])[0]


def blocked_times(options: argparse.Namespace, log: Path, radius_m: float) -> Dict[str, float]:
    found: Dict[str, float] = {}
    for row in triggers.table(options, log, "scarab/world_state", "object.position_m[0]", "obstacle_x_m", "obstacle_present"):
        gap_m = float(row["object.position_m[0]"]) - radius_m - float(row["obstacle_x_m"])
        if row["obstacle_present"] == "true" and gap_m < triggers.BLOCKED_GAP_M:
            found.setdefault(row["header.trial"], int(row["header.sim_time_ns"]) * 1e-9)
    return found


def margins_of(options: argparse.Namespace, log: Path, radius_m: float, sign: float) -> Margins:
    blocked_at = blocked_times(options, log, radius_m)
    free: Dict[str, float] = {}
    blocked: Dict[str, float] = {}
    for trial, time_s, value in in_mode_1(options, log, sign):
        since_s: Optional[float] = time_s - blocked_at[trial] if trial in blocked_at else None
        if since_s is None or since_s < 0:
            free[trial] = max(free.get(trial, value), value)
        elif since_s <= REACH_S:
            blocked[trial] = max(blocked.get(trial, value), value)
    return Margins([sign * value for value in free.values()], [sign * value for value in blocked.values()])


def report(strategy: str, scale: float, margins: Margins, sign: float) -> str:
    farthest, nearest = (max, min) if sign > 0 else (min, max)
    if not margins.free or not margins.blocked:
        raise RuntimeError("no trial has reached mode 1 and the wall")
    return (f"| {strategy} | {scale:g} | {statistics.median(margins.free):.3f} | {farthest(margins.free):.3f} | "
            f"{nearest(margins.blocked):.3f} | {statistics.median(margins.blocked):.3f} | {len(margins.blocked)} |")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, epilog=_HELP,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=triggers.ROOT / "build/release/bin", help="built programs")
    parser.add_argument("--trials", type=int, default=20, help="how many seeds (20)")
    parser.add_argument("--seed", type=int, default=1, help="the first of them (1)")
    parser.add_argument("--scale", type=float, nargs="+", default=[0, 1], help="of the sensors' errors (0 1)")
    parser.add_argument("--trigger", choices=triggers.TRIGGERS, default="supply_current", help="(supply_current)")
    parser.add_argument("--strategy", nargs="+", default=["soft+hard", "stationary+hard", "boxing+hard"],
                        help="strategies whose mode 1 is looked at (the three with two modes)")
    parser.add_argument("--height", type=float, default=0.10, help="of the obstacle, m (0.10)")
    parser.add_argument("--supervisor", type=Path, default=triggers.ROOT / "config/supervisor/beetle.yaml",
                        help="the supervisor's file")
    options = parser.parse_args()
    options.only = []
    strategies, sign = options.strategy, -1.0 if options.trigger == "front_angle" else 1.0
    radius_m = triggers.object_radius_m()
    print("| strategy | scale | free: median | free: worst | blocked: worst | blocked: median | trials |")
    print("|---|---|---|---|---|---|---|")
    for options.strategy in strategies:
        for scale in options.scale:
            with tempfile.TemporaryDirectory() as name:
                folder = Path(name)
                supervisor = never_switching(folder, options.supervisor, options.strategy, options.trigger)
                triggers.simulate(options, triggers.scaled_file(folder, scale, []), supervisor, folder / "trials.mcap")
                margins = margins_of(options, folder / "trials.mcap", radius_m, sign)
                print(report(options.strategy, scale, margins, sign), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
