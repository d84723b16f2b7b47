"""The options that say what a stack consists of, and how fast it goes."""

import argparse
import os
from pathlib import Path
from typing import Callable, Dict, List, Tuple, TypeVar

from .failure import UsageError
from .places import default_bin, default_runs, default_stack_file
from .stack import Pace
from .stack_changes import MOST_INSTANCES, StackChanges

DEFAULT_PROFILE = "sim"
ROBOT_PROFILE = "robot"
T = TypeVar("T")


def bounded_integer(low: int, high: int) -> Callable[[str], int]:
    """An argparse type: digits alone, for a number in [low, high]."""
    def parse(text: str) -> int:
        if not text.isascii() or not text.isdigit():
            raise argparse.ArgumentTypeError(f"'{text}' is not a whole number")
        if not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(f"{text} is out of range [{low}, {high}]")
        return int(text)
    return parse


def add_place_options(parser: argparse.ArgumentParser, domain: bool) -> None:
    """Of every verb: where things are."""
    places = parser.add_argument_group("places")
    if domain:
        places.add_argument("--domain", type=bounded_integer(0, 230), metavar="N",
                            help="DDS domain of the stack")
    places.add_argument("--stack", type=Path, metavar="FILE", default=default_stack_file(),
                        help="description of the stack (deploy/stack.yaml)")
    places.add_argument("--bin", type=Path, metavar="DIR", default=default_bin(),
                        help="compiled programs (build/release/bin)")
    places.add_argument("--runs", type=Path, metavar="DIR", default=default_runs(),
                        help="where the run directories are (runs)")


def add_profile_option(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--profile", metavar="NAME", default=DEFAULT_PROFILE,
                        help="which of the profiles of stack.yaml: the services to start here (sim)")


def add_data_options(parser: argparse.ArgumentParser) -> None:
    """What can be changed in processes and in one process alike: the data."""
    data = parser.add_argument_group("data")
    data.add_argument("--robot", metavar="NAME",
                      help="which robot, one of config/robot (the one that stack.yaml names)")
    data.add_argument("--config", action="append", default=[], type=_service_file,
                      metavar="SERVICE=FILE",
                      help="another configuration file for a service, such as "
                           "plant=config/plant/beetle-noisy.yaml; repeatable")


def add_stack_options(parser: argparse.ArgumentParser) -> None:
    add_profile_option(parser)
    parser.add_argument("--replicas", action="append", default=[], type=_replicas,
                        metavar="SERVICE=N",
                        help="how many processes of a service, such as premotor=2 for a hot spare; "
                             "repeatable, or with commas")
    parser.add_argument("--no-log", dest="log", action="store_false",
                        help="a stack without logger; on two hosts, on both")
    parser.add_argument("--tag", metavar="TEXT", help="discovery tag of Cyclone DDS (none)")
    parser.add_argument("--interface", metavar="NAME",
                        help="network interface of the DDS traffic (the one that stack.yaml names)")
    parser.add_argument("--peers", metavar="ADDRESS,...", type=lambda text: tuple(text.split(",")),
                        help="the other hosts, on a network without multicast (bus.peers)")
    add_data_options(parser)
    add_device_options(parser).add_argument(
        "--emulated", action="store_true",
        help="without the robot: its boards are emulated, with a simulated robot behind them")


def add_device_options(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Of the profile `robot`; returns their group."""
    device = parser.add_argument_group("device, of a profile with a robot bridge")
    device.add_argument("--driver", metavar="NAME",
                        help="of the robot's board: config/robot_bridge has a file ROBOT-NAME.yaml for each "
                             "(the one that stack.yaml names)")
    device.add_argument("--device", type=_device, metavar="PATH",
                        help="the port that the robot is at (the one of that file)")
    return device


def add_pace_options(parser: argparse.ArgumentParser, default: Pace) -> None:
    """`--lockstep` and `--realtime`; options.pace is None where nothing was said."""
    pace = parser.add_argument_group("pace").add_mutually_exclusive_group()
    for value, text in ((Pace.LOCKSTEP, "the tick master waits for every answer: as fast as it goes"),
                        (Pace.REALTIME, "by the wall clock: 38 s of a trial take 38 s")):
        note = " (this is the default)" if value is default else ""
        pace.add_argument(f"--{value.value}", dest="pace", action="store_const", const=value,
                          help=text + note)


def changes_of(options: argparse.Namespace) -> StackChanges:
    """What add_data_options or add_stack_options have read. UsageError for a service named twice."""
    pairs = [pair for pairs in getattr(options, "replicas", []) for pair in pairs]
    return StackChanges(
        robot=getattr(options, "robot", None),
        driver=getattr(options, "driver", None),
        device=getattr(options, "device", None),
        emulated=getattr(options, "emulated", False),
        replicas=_once("--replicas", pairs),
        configs=_once("--config", getattr(options, "config", [])),
        interface=getattr(options, "interface", None),
        tag=getattr(options, "tag", None),
        peers=getattr(options, "peers", None),
        log=getattr(options, "log", True))


def _once(option: str, pairs: List[Tuple[str, T]]) -> Dict[str, T]:
    found: Dict[str, T] = {}
    for name, value in pairs:
        if name in found:
            raise UsageError(f"{option}: '{name}' is named twice")
        found[name] = value
    return found


def _replicas(text: str) -> List[Tuple[str, int]]:
    pairs = []
    for part in text.split(","):
        name, equals, count = part.partition("=")
        if not name or not equals:
            raise argparse.ArgumentTypeError(f"'{part}' is not SERVICE=N, such as premotor=2")
        pairs.append((name, bounded_integer(1, MOST_INSTANCES)(count)))
    return pairs


def _device(text: str) -> Path:
    """An argparse type. Not resolved: a link such as /dev/serial/by-id/... names the device for good."""
    if not text:
        raise argparse.ArgumentTypeError("a path is missing")
    return Path(os.path.abspath(text))


def _service_file(text: str) -> Tuple[str, Path]:
    name, equals, file = text.partition("=")
    if not name or not equals or not file:
        raise argparse.ArgumentTypeError(
            f"'{text}' is not SERVICE=FILE, such as plant=config/plant/beetle-noisy.yaml")
    return name, Path(file).resolve()
