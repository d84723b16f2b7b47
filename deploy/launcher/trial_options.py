"""The options of a trial, checked before anything is started and handed on to the experiment."""

import argparse
import re
from typing import Callable, Dict, List

from .failure import UsageError
from .stack_options import bounded_integer

_NUMBER = re.compile(r"-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
GOALS = ("across", "travel", "walk", "none")


def bounded_number(low: float, high: float) -> Callable[[str], str]:
    """An argparse type: a number in [low, high], kept as the text that was given."""
    def parse(text: str) -> str:
        if not _NUMBER.fullmatch(text):
            raise argparse.ArgumentTypeError(f"'{text}' is not a number")
        if not low <= float(text) <= high:
            raise argparse.ArgumentTypeError(f"{text} is out of range [{low:g}, {high:g}]")
        return text
    return parse


# Those that take a value, by the name of their attribute; the programs know the same ranges.
PARSERS: Dict[str, Callable[[str], object]] = {
    "strategy": str,
    "height": bounded_number(0.0, 0.5),
    "goal": str,
    "distance": bounded_number(0.01, 10.0),
    "seed": bounded_integer(0, 2**64 - 1),
    "trials": bounded_integer(1, 100000),
    "time_limit": bounded_number(0.1, 36000.0),
    "perturb_position": bounded_number(0.0, 0.2),
    "perturb_yaw": bounded_number(0.0, 3.1415926535897932),
    "perturb_friction": bounded_number(0.0, 0.9),
    "friction_scale": bounded_number(0.01, 10.0),
    "object_mass": bounded_number(0.0, 100.0),
    "object_diameter": bounded_number(0.0, 1.0),
}
_NOTES = {
    "strategy": ("NAME", "pushing strategy of the supervisor's configuration (soft+hard)"),
    "height": ("M", "height of the obstacle in metres; 0: none (0.10)"),
    "goal": ("", "object across the obstacle, object moved by --distance, robot moved by --distance, or none: "
                 "go on until the time limit (across; without an obstacle travel)"),
    "distance": ("M", "for the goals travel and walk (1.46)"),
    "seed": ("N", "of every perturbation of the first trial; later ones count on (1)"),
    "trials": ("N", "how many trials, one after the other (1)"),
    "time_limit": ("S", "simulated seconds until a trial has failed (60)"),
    "perturb_position": ("M", "start position: uniform in +- this, x and y (0.02)"),
    "perturb_yaw": ("RAD", "start heading: uniform in +- this (0.0524, which is 3 deg)"),
    "perturb_friction": ("SHARE", "every friction coefficient has a factor of its own, uniform in 1 +- this "
                                  "(0.1)"),
    "friction_scale": ("X", "of every friction coefficient (1)"),
    "object_mass": ("KG", "mass of the object; 0: as configured (0)"),
    "object_diameter": ("M", "diameter of the object; 0: as configured (0)"),
}


def option_of(name: str) -> str:
    """As it is typed."""
    return "--" + name.replace("_", "-")


def add_trial_options(parser: argparse.ArgumentParser) -> None:
    """deploy/arguments.sh knows the same options; a test holds the two together."""
    trial = parser.add_argument_group("trial")
    for name, parse in PARSERS.items():
        metavar, note = _NOTES[name]
        values = {"choices": GOALS} if name == "goal" else {"type": parse, "metavar": metavar}
        trial.add_argument(option_of(name), help=note, **values)
    trial.add_argument("--no-perturbation", action="store_true",
                       help="start exactly in the nominal pose and phase, with the nominal friction")
    trial.add_argument("--row", metavar="FILE:N",
                       help="the trial with index N of an experiment's results.csv; options beside it "
                            "change it")


def trial_arguments(options: argparse.Namespace) -> List[str]:
    """The options that were given, as the experiment and the simulation take them."""
    arguments: List[str] = []
    for name in PARSERS:
        value = getattr(options, name)
        if value is not None:
            arguments += [option_of(name), str(value)]
    if options.no_perturbation:
        arguments.append("--no-perturbation")
    return arguments


def check_trial(options: argparse.Namespace) -> None:
    """UsageError for options that contradict each other."""
    if options.goal == "across" and options.height is not None and float(options.height) == 0.0:
        raise UsageError("--goal across needs an obstacle: --height greater than 0")
