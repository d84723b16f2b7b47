"""The options of a trial, checked before anything is started and handed on to the experiment."""

import argparse
import re
from typing import Callable, List

from .failure import UsageError
from .stack_options import bounded_integer

_NUMBER = re.compile(r"-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
GOALS = ("across", "travel", "none")


def bounded_number(low: float, high: float) -> Callable[[str], str]:
    """An argparse type: a number in [low, high], kept as the text that was given."""
    def parse(text: str) -> str:
        if not _NUMBER.fullmatch(text):
            raise argparse.ArgumentTypeError(f"'{text}' is not a number")
        if not low <= float(text) <= high:
            raise argparse.ArgumentTypeError(f"{text} is out of range [{low:g}, {high:g}]")
        return text
    return parse


def add_trial_options(parser: argparse.ArgumentParser) -> None:
    """deploy/arguments.sh knows the same options; a test holds the two together."""
    trial = parser.add_argument_group("trial")
    trial.add_argument("--strategy", metavar="NAME",
                       help="pushing strategy of the supervisor's configuration (soft+hard)")
    trial.add_argument("--height", type=bounded_number(0.0, 0.5), metavar="M",
                       help="height of the obstacle in metres; 0: none (0.10)")
    trial.add_argument("--goal", choices=GOALS,
                       help="object across the obstacle, object moved by --distance, or none: go on until "
                            "the time limit (across; without an obstacle travel)")
    trial.add_argument("--distance", type=bounded_number(0.01, 10.0), metavar="M",
                       help="for --goal travel (1.46)")
    trial.add_argument("--seed", type=bounded_integer(0, 2**64 - 1), metavar="N",
                       help="of every perturbation of the first trial; later ones count on (1)")
    trial.add_argument("--trials", type=bounded_integer(1, 100000), metavar="N",
                       help="how many trials, one after the other (1)")
    trial.add_argument("--time-limit", type=bounded_number(0.1, 36000.0), metavar="S",
                       help="simulated seconds until a trial has failed (60)")
    trial.add_argument("--no-perturbation", action="store_true",
                       help="start exactly in the nominal pose")


def trial_arguments(options: argparse.Namespace) -> List[str]:
    """The options that were given, as the experiment and the simulation take them."""
    arguments: List[str] = []
    for name in ("strategy", "height", "goal", "distance", "seed", "trials", "time_limit"):
        value = getattr(options, name)
        if value is not None:
            arguments += ["--" + name.replace("_", "-"), str(value)]
    if options.no_perturbation:
        arguments.append("--no-perturbation")
    return arguments


def check_trial(options: argparse.Namespace) -> None:
    """UsageError for options that contradict each other."""
    if options.goal == "across" and options.height is not None and float(options.height) == 0.0:
        raise UsageError("--goal across needs an obstacle: --height greater than 0")
