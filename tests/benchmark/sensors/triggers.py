#!/usr/bin/python3
"""Up to which level of sensor noise the supervisor's triggers stay right."""

import argparse
import csv
import io
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, Dict, Iterator, List, NamedTuple, Optional

import yaml

ROOT = Path(__file__).resolve().parents[3]
NOISY = ROOT / "config/plant/beetle-noisy.yaml"
LATE_S = 4.0          # after the object was blocked; without noise mode 2 begins 1.9 to 3.1 s after it
BLOCKED_GAP_M = 0.01  # between object and obstacle
REACH_M = 0.40        # from the trunk's centre to the object's axis: nearer, the hind feet are on the object
TIMES = ("latency_s", "jitter_s")
TRIGGERS = ("front_angle", "supply_current", "foot_force")

_HELP = """Runs trials in one process (scarab-sim) with the errors of config/plant/beetle-noisy.yaml multiplied by each
scale; latencies and jitter too, in whole steps. --only SECTION.KEY, repeatable, multiplies these alone and leaves
all others out. --trigger has the strategy switch by this signal, whatever the supervisor's file prefers. By the ground
truth, mode 1 is right if the robot has its hind feet on the object, mode 2 if it begins after the obstacle has blocked
the object, and within 4 s of it. Times are smallest, median, largest.

example:
  tests/benchmark/sensors/triggers.py --bin build/release/bin --trials 40 --scale 0 1 2 4
  tests/benchmark/sensors/triggers.py --trials 40 --scale 4 --only inclination.bias_rad
  tests/benchmark/sensors/triggers.py --trials 100 --seed 1001 --trigger supply_current
"""


class Trial(NamedTuple):
    climb_s: Optional[float]
    mode_1_s: Optional[float]
    mode_2_s: Optional[float]
    blocked_s: Optional[float]
    mode_1_m: Optional[float]  # from trunk to object when mode 1 begins
    success: bool


def scaled_file(folder: Path, scale: float, only: List[str]) -> Path:
    """A plant file with the noisy file's errors times `scale`."""
    noisy = yaml.safe_load(NOISY.read_text(encoding="utf-8"))
    base = yaml.safe_load((NOISY.parent / noisy["extends"]).read_text(encoding="utf-8"))
    step_s = base["timing"]["step_s"]

    def scaled(section: str, key: str, value: float) -> float:
        if only and f"{section}.{key}" not in only:
            return 0.0
        if key in TIMES:
            return round(round(scale * value / step_s) * step_s, 9)
        return round(scale * value, 9)

    base["sensors"] = {sensor: {key: scaled(sensor, key, value) for key, value in errors.items()}
                       for sensor, errors in noisy["sensors"].items()}
    base["commands"] = {key: scaled("commands", key, value)
                        for key, value in noisy["commands"].items()}
    path = folder / "plant.yaml"
    path.write_text(yaml.safe_dump(base, sort_keys=False), encoding="utf-8")
    return path


def object_radius_m() -> float:
    return yaml.safe_load((NOISY.parent / "beetle.yaml").read_text(encoding="utf-8"))["object"]["diameter_m"] / 2


def supervisor_file(folder: Path, options: argparse.Namespace) -> Path:
    """The supervisor's file; with --trigger one that has only this signal switch."""
    if options.trigger is None:
        return options.supervisor
    path = folder / "supervisor.yaml"
    changed = {"extends": str(options.supervisor.resolve()),
               "strategies": {options.strategy: {"obstacle": [options.trigger]}}}
    path.write_text(yaml.safe_dump(changed, sort_keys=False), encoding="utf-8")
    return path


def simulate(options: argparse.Namespace, plant: Path, supervisor: Path, log: Path) -> None:
    command = [str(options.bin / "scarab-sim"), "--quiet", "--plant", str(plant),
               "--robot", str(ROOT / "config/robot/beetle.yaml"),
               "--premotor", str(ROOT / "config/premotor/beetle.yaml"),
               "--supervisor", str(supervisor),
               "--strategy", options.strategy, "--height", str(options.height),
               "--trials", str(options.trials), "--seed", str(options.seed), "--output", str(log)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, 1):  # a failed trial is a result
        raise RuntimeError(f"scarab-sim ended with {done.returncode}: {done.stderr}")


def table(options: argparse.Namespace, log: Path, topic: str, *fields: str) -> Iterator[Dict[str, str]]:
    command = [str(options.bin / "scarab-log"), "export", str(log), "--format", "csv",
               "--topic", topic]
    for field in ("header.trial", "header.sim_time_ns", *fields):
        command += ["--field", field]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return csv.DictReader(io.StringIO(done.stdout))


def read_trials(options: argparse.Namespace, log: Path, radius_m: float) -> List[Trial]:
    found: Dict[str, Dict[str, Any]] = {}
    mode_1_at: Dict[str, str] = {}
    for row in table(options, log, "scarab/behaviour", "state"):
        trial = found.setdefault(row["header.trial"], {})
        # The robot may slip off the object and climb again: mode 1 starts once, climb counts the first time.
        trial.setdefault(row["state"], int(row["header.sim_time_ns"]) * 1e-9)
        if row["state"] == "BEHAVIOUR_MODE_1":
            mode_1_at.setdefault(row["header.trial"], row["header.sim_time_ns"])
    for row in table(options, log, "scarab/world_state", "object.position_m[0]", "trunk.position_m[0]",
                     "obstacle_x_m", "obstacle_present", "verdict"):
        trial = found[row["header.trial"]]
        object_m = float(row["object.position_m[0]"])
        if mode_1_at.get(row["header.trial"]) == row["header.sim_time_ns"]:
            trial["mode_1_m"] = float(row["trunk.position_m[0]"]) - object_m
        gap_m = object_m - radius_m - float(row["obstacle_x_m"])
        if row["obstacle_present"] == "true" and gap_m < BLOCKED_GAP_M:
            trial.setdefault("blocked", int(row["header.sim_time_ns"]) * 1e-9)
        trial["success"] = row["verdict"] == "VERDICT_SUCCESS"
    return [Trial(trial.get("BEHAVIOUR_CLIMB"), trial.get("BEHAVIOUR_MODE_1"), trial.get("BEHAVIOUR_MODE_2"),
                  trial.get("blocked"), trial.get("mode_1_m"), trial["success"]) for trial in found.values()]


def spread(values: List[Optional[float]]) -> str:
    known = [value for value in values if value is not None]
    if not known:
        return "-"
    return f"{min(known):.1f} {statistics.median(known):.1f} {max(known):.1f}"


def report(scale: float, trials: List[Trial]) -> str:
    switched = [t for t in trials if t.mode_2_s is not None]
    early = [t for t in switched if t.blocked_s is None or t.mode_2_s < t.blocked_s]
    delays = [t.mode_2_s - t.blocked_s for t in switched if t not in early]
    off_object = sum(t.mode_1_m is not None and t.mode_1_m > REACH_M for t in trials)
    late = sum(delay > LATE_S for delay in delays)
    return (f"| {scale:g} | {sum(t.success for t in trials)}/{len(trials)} | {spread([t.climb_s for t in trials])} | "
            f"{spread([t.mode_1_s for t in trials])} | {off_object} | {spread(delays)} | {len(early)} | {late} | "
            f"{len(trials) - len(switched)} |")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, epilog=_HELP,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin", help="built programs")
    parser.add_argument("--trials", type=int, default=40, help="how many seeds (40)")
    parser.add_argument("--seed", type=int, default=1, help="the first of them (1)")
    parser.add_argument("--scale", type=float, nargs="+", default=[0, 1, 2, 4], help="of the errors (0 1 2 4)")
    parser.add_argument("--only", action="append", default=[], metavar="SECTION.KEY", help="these errors alone")
    parser.add_argument("--strategy", default="soft+hard", help="pushing strategy (soft+hard)")
    parser.add_argument("--trigger", choices=TRIGGERS, help="switch to mode 2 by this signal (as the file has it)")
    parser.add_argument("--height", type=float, default=0.10, help="of the obstacle, m; 0: none (0.10)")
    parser.add_argument("--supervisor", type=Path, default=ROOT / "config/supervisor/beetle.yaml",
                        help="the supervisor's file")
    options = parser.parse_args()
    radius_m = object_radius_m()
    print("| scale | success | climb, s | mode 1, s | off the object | mode 2 after blocked, s | early | late | never |")
    print("|---|---|---|---|---|---|---|---|---|")
    for scale in options.scale:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            simulate(options, scaled_file(folder, scale, options.only), supervisor_file(folder, options),
                     folder / "trials.mcap")
            print(report(scale, read_trials(options, folder / "trials.mcap", radius_m)), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
