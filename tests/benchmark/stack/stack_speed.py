#!/usr/bin/python3
"""Speed of the plant alone, of the cores in one process and of the stack, with and without logger."""

import argparse
import contextlib
import json
import re
import statistics
import subprocess
import sys
import tempfile
import uuid
from pathlib import Path
from typing import List, Tuple

import comparison
import machine

ROOT = Path(__file__).resolve().parents[3]
PLANT_AIM = 250  # x real time, on one core
STACK_AIM = 40   # x real time, on two cores
LOGGER_AIM = 0.9  # of the stack's speed without a logger
TRIAL_LIMIT_S = 300
SPEED_ROUNDS = 5  # of what is no comparison: the plant, one process
_RESULT = re.compile(r"^.*result: \w+ after ([\d.]+) s.*; ([\d.]+) x real time\)$", re.MULTILINE)

_HELP = """A trial's speed is its simulated time over the wall time from its first tick to its last.

What the logger costs: a stack with and one without a logger are up side by side, and trials alternate
between them, so that start-up does not count and a slow moment of the machine hits both. The figure
is the median of the ratios of neighbours, with the interval in which the true median lies in 95 of
100 such runs; below it is said whether that decides. A machine that is busy with other things cannot
decide it: the share of its processors that others took meanwhile is told.

examples:
  tests/benchmark/stack/stack_speed.py --bin build/release/bin
  tests/benchmark/stack/stack_speed.py --repeats 200     a narrower interval
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


class Stack:
    """Processes in lockstep, up from `with` to its end. Between trials they sleep."""

    def __init__(self, options: argparse.Namespace, with_logger: bool):
        self._options = options
        self._members = (["logger"] if with_logger else []) + ["plant", "supervisor", "premotor"]
        self._bus = ["--tag", f"stack-speed-{uuid.uuid4()}",
                     "--expect", ",".join(f"{service}=1" for service in self._members)]
        self._to_undo = contextlib.ExitStack()

    def __enter__(self) -> "Stack":
        run_dir = self._to_undo.enter_context(tempfile.TemporaryDirectory(prefix="scarab-speed-"))
        try:
            for service in self._members:
                self._start(service, run_dir)
        except OSError:
            self._to_undo.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._to_undo.close()

    def _start(self, service: str, run_dir: str) -> None:
        command = [str(self._options.bin / f"scarab-{service}"), *self._bus, "--run-dir", run_dir,
                   *shipped(service)]
        if service == "logger":
            command += ["--output", f"{run_dir}/trial.mcap"]
        process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
        self._to_undo.callback(process.wait, timeout=20)
        self._to_undo.callback(process.terminate)  # undone in the opposite order: the logger last

    def speed(self) -> float:
        return speed_of(finish([str(self._options.bin / "scarab-experiment"), *self._bus,
                                *trial_options(self._options),
                                "--trials", str(self._options.trials)]))[1]


def compare_stacks(options: argparse.Namespace) -> Tuple[List[float], List[float]]:
    """Speeds without and with a logger, neighbours at the same index."""
    without, recorded = [], []
    with Stack(options, False) as bare, Stack(options, True) as full:
        for stack in (bare, full):
            stack.speed()  # the first trial waits for everybody to find everybody
        for number in range(options.repeats):
            turns = [(bare, without), (full, recorded)]
            for stack, speeds in turns if number % 2 == 0 else reversed(turns):
                speeds.append(stack.speed())
    return without, recorded


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


def row(name: str, speeds: List[float], aim: str) -> str:
    return (f"{name:<34} {statistics.median(speeds):7.1f} x real time   "
            f"({min(speeds):.1f} to {max(speeds):.1f} of {len(speeds)}){aim}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, epilog=_HELP,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin",
                        help="compiled programs (build/release/bin)")
    parser.add_argument("--repeats", type=int, default=60,
                        help="pairs of neighbours, with and without a logger (60)")
    parser.add_argument("--trials", type=int, default=2, help="trials of each neighbour (2)")
    parser.add_argument("--time-limit", type=float, help="end the trials after so many simulated s")
    options = parser.parse_args()
    if options.repeats < 1 or options.trials < 1:
        parser.error("--repeats and --trials must be at least 1")
    try:
        rounds = range(min(options.repeats, SPEED_ROUNDS))
        plants = [plant_speed(options) for _ in rounds]
        simulated = [simulate(options) for _ in rounds]
        before = machine.Usage.now()
        without, recorded = compare_stacks(options)
        others = before.share_of_others()
    except (RuntimeError, OSError, subprocess.TimeoutExpired) as error:
        print(f"stack_speed: {error}", file=sys.stderr)
        return 1
    sims = [speed for _, speed in simulated]
    print(f"soft+hard over 0.10 m, {simulated[0][0]:.1f} s simulated, medians")
    print(row("plant alone (CPU time, one core)", plants, f", aim {PLANT_AIM}"))
    print(row("scarab-sim, one process", sims, ""))
    print(row("stack of processes, no logger", without, ""))
    print(row("stack of processes, with logger", recorded, f", aim {STACK_AIM}"))
    print(f"stack with logger / scarab-sim     {statistics.median(recorded) / statistics.median(sims):7.2f}")
    kept = comparison.Ratios([one / other for one, other in zip(recorded, without)])
    print(f"with logger / without              {kept}")
    print(f"the logger costs {comparison.percent(1 - kept.median)} of the speed; "
          f"at most {comparison.percent(1 - LOGGER_AIM)}: {kept.judge(LOGGER_AIM)}")
    print(f"others took {comparison.percent(others)} of the processors meanwhile")
    return 0


if __name__ == "__main__":
    sys.exit(main())
