#!/usr/bin/python3
"""Speed of the plant alone, of the cores in one process and of the stack, with and without logger."""

import argparse
import json
import re
import statistics
import subprocess
import sys
import tempfile
import uuid
from pathlib import Path
from typing import Dict, List, Tuple

ROOT = Path(__file__).resolve().parents[3]
PLANT_AIM = 250  # x real time, on one core
STACK_AIM = 40   # x real time, on two cores
LOGGER_AIM = 0.9  # of the stack's speed without a logger
TRIAL_LIMIT_S = 300
_RESULT = re.compile(r"^.*result: \w+ after ([\d.]+) s.*; ([\d.]+) x real time\)$", re.MULTILINE)

_HELP = """A trial's speed is its simulated time over the wall time from its first tick to its last.
All are measured in this one run and in turns, so that their ratios mean something on a noisy
machine. A stack runs --trials trials; its speed is that of all of them. What the logger costs is the
median of the ratios of neighbours: each round runs a stack with and one without a logger, the one
first that was last before.

example:
  tests/benchmark/stack/stack_speed.py --bin build/release/bin --repeats 5
"""


def shipped(service: str) -> List[str]:
    """Robot and configuration file of a service."""
    config = {"plant": "plant/beetle.yaml", "premotor": "premotor/beetle.yaml",
              "supervisor": "supervisor/beetle.yaml"}
    words = []
    if service in ("plant", "premotor"):
        words += ["--robot", str(ROOT / "config/robot/beetle.yaml")]
    if service in config:
        words += ["--config", str(ROOT / "config" / config[service])]
    return words


def trial_options(options: argparse.Namespace) -> List[str]:
    words = ["--strategy", "soft+hard", "--height", "0.10", "--seed", "1", "--quiet"]
    if options.time_limit is not None:
        words += ["--time-limit", str(options.time_limit)]
    return words


def speed_of(output: str) -> Tuple[float, float]:
    """Simulated seconds and speed of all trials together that `output` reports."""
    found = [(float(seconds), float(speed)) for seconds, speed in _RESULT.findall(output)]
    if not found:
        raise RuntimeError(f"no result in: {output}")
    simulated_s = sum(seconds for seconds, _ in found)
    return simulated_s, simulated_s / sum(seconds / speed for seconds, speed in found)


def finish(command: List[str]) -> str:
    """Stdout of a program that ends by itself; a failed trial is no failure here."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          timeout=TRIAL_LIMIT_S, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{command[0]} ended with {done.returncode}: {done.stderr}")
    return done.stdout


def simulate(options: argparse.Namespace) -> Tuple[float, float]:
    command = [str(options.bin / "scarab-sim"), "--robot", str(ROOT / "config/robot/beetle.yaml")]
    for service in ("plant", "premotor", "supervisor"):
        command += ["--" + service, shipped(service)[-1]]
    return speed_of(finish(command + trial_options(options)))


def run_stack(options: argparse.Namespace, with_logger: bool) -> Tuple[float, float]:
    """Trials on a fresh stack of processes, in lockstep."""
    members = (["logger"] if with_logger else []) + ["plant", "supervisor", "premotor"]
    bus = ["--tag", f"stack-speed-{uuid.uuid4()}",
           "--expect", ",".join(f"{service}=1" for service in members)]
    services = []
    with tempfile.TemporaryDirectory(prefix="scarab-speed-") as run_dir:
        try:
            for service in members:
                command = [str(options.bin / f"scarab-{service}"), *bus, "--run-dir", run_dir,
                           *shipped(service)]
                if service == "logger":
                    command += ["--output", f"{run_dir}/trial.mcap"]
                services.append(subprocess.Popen(command, stderr=subprocess.DEVNULL))
            return speed_of(finish([str(options.bin / "scarab-experiment"), *bus,
                                    *trial_options(options), "--trials", str(options.trials)]))
        finally:
            for service in reversed(services):  # the logger last
                service.terminate()
                service.wait(timeout=20)


def plant_speed(options: argparse.Namespace) -> float:
    """Of the plant's own benchmark: pushing, at the step of the shipped configuration."""
    step_us = round(float(re.search(r"^\s*step_s:\s*([\d.e-]+)", Path(shipped("plant")[-1]).read_text(),
                                    re.MULTILINE)[1]) * 1e6)
    output = finish([str(options.bin / "benchmark_plant"), "--benchmark_format=json",
                     f"--benchmark_filter=pushing/step_us:{step_us}/"])
    benchmarks = json.loads(output)["benchmarks"]
    if not benchmarks:
        raise RuntimeError(f"benchmark_plant has no pushing at a step of {step_us} us")
    return benchmarks[0]["real_time_factor"]


def neighbours(options: argparse.Namespace, number: int) -> Dict[bool, float]:
    """Speeds of a stack with (True) and without a logger, one right after the other."""
    order = (False, True) if number % 2 == 0 else (True, False)
    return {with_logger: run_stack(options, with_logger)[1] for with_logger in order}


def row(name: str, speeds: List[float], aim: str) -> str:
    return (f"{name:<34} {statistics.median(speeds):7.1f} x real time   "
            f"({min(speeds):.1f} to {max(speeds):.1f} of {len(speeds)}){aim}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, epilog=_HELP,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin",
                        help="compiled programs (build/release/bin)")
    parser.add_argument("--repeats", type=int, default=5, help="rounds (5)")
    parser.add_argument("--trials", type=int, default=3, help="trials of each stack (3)")
    parser.add_argument("--time-limit", type=float, help="end the trials after so many simulated s")
    options = parser.parse_args()
    if options.repeats < 1 or options.trials < 1:
        parser.error("--repeats and --trials must be at least 1")
    sims, plants, without, recorded = [], [], [], []
    try:
        for number in range(options.repeats):  # in turn: a slow moment of the machine hits all alike
            plants.append(plant_speed(options))
            simulated_s, speed = simulate(options)
            sims.append(speed)
            speeds = neighbours(options, number)
            without.append(speeds[False])
            recorded.append(speeds[True])
    except (RuntimeError, OSError, subprocess.TimeoutExpired) as error:
        print(f"stack_speed: {error}", file=sys.stderr)
        return 1
    print(f"soft+hard over 0.10 m, {simulated_s:.1f} s simulated, median of {options.repeats}")
    print(row("plant alone (CPU time, one core)", plants, f", aim {PLANT_AIM}"))
    print(row("scarab-sim, one process", sims, ""))
    print(row("stack of processes, no logger", without, ""))
    print(row("stack of processes, with logger", recorded, f", aim {STACK_AIM}"))
    kept = [one / other for one, other in zip(recorded, without)]
    print(f"with logger / without              {statistics.median(kept):7.2f}               "
          f"({min(kept):.2f} to {max(kept):.2f} of {len(kept)}), aim {LOGGER_AIM}")
    print(f"stack with logger / scarab-sim     {statistics.median(recorded) / statistics.median(sims):7.2f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
