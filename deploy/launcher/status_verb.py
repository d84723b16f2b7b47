"""`scarab status` and `scarab logs`: what runs, and what it says."""

import argparse
import os
import sys

from .failure import EXIT_FAILURE, EXIT_OK, Failure, UsageError
from .places import Places, shown
from .run_directory import RunDirectory
from .running_stack import choose_stack
from .service_child import last_lines
from .signals import Signals
from .status.onlooker import Onlooker
from .status.screen import Screen
from .status.show import shown_as
from .strict_yaml import did_you_mean

_SHORTEST_S, _LONGEST_S = 0.2, 3600.0


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--watch", action="store_true",
                        help="again and again, until Ctrl-C; drawn over itself on a terminal")
    parser.add_argument("--period", type=_period, default=1.0, metavar="S",
                        help="seconds between two looks of --watch (1)")
    parser.add_argument("--json", action="store_true",
                        help="one JSON document, with --watch one a line; tools/status/README.md has "
                             "its keys")


def status(options: argparse.Namespace, places: Places) -> int:
    """0 if a stack runs and all is well with those that run; with --watch 0 when it is stopped."""
    signals = Signals()
    with Onlooker(places, options.domain, options.period if options.watch else None) as onlooker:
        if options.watch:
            return _watch(onlooker, signals, options.json)
        pictures = onlooker.look(signals)
        signals.raise_if_stop_requested()
        troubles = onlooker.troubles(pictures)
        print("\n".join(shown_as(pictures, troubles, options.json, sys.stdout)))
        return EXIT_FAILURE if troubles else EXIT_OK


def _watch(onlooker: Onlooker, signals: Signals, as_json: bool) -> int:
    if as_json:
        while not signals.stop_requested:
            pictures = onlooker.look(signals)
            if not signals.stop_requested:
                text = shown_as(pictures, onlooker.troubles(pictures), True, sys.stdout, one_line=True)
                print(*text, flush=True)
        return EXIT_OK
    with Screen(sys.stdout) as screen:
        while not signals.stop_requested:
            pictures = onlooker.look(signals)
            if not signals.stop_requested:
                screen.draw(shown_as(pictures, onlooker.troubles(pictures), False, sys.stdout))
    return EXIT_OK


def _period(text: str) -> float:
    """An argparse type: seconds."""
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number of seconds") from None
    if not _SHORTEST_S <= value <= _LONGEST_S:
        raise argparse.ArgumentTypeError(
            f"{text} is out of range [{_SHORTEST_S:g}, {_LONGEST_S:g}]")
    return value


def logs(options: argparse.Namespace, places: Places) -> int:
    """Of the running stack, else of the latest run."""
    stack = choose_stack(places.runs, options.domain)
    directory = stack.directory if stack else RunDirectory((places.runs / "latest").resolve())
    files = sorted(directory.logs.glob("*.log"))
    if not files:
        raise Failure(f"there are no logs yet in {shown(places.runs)}")
    if options.service:
        names = [f.stem for f in files]
        if options.service not in names:
            raise UsageError(f"no log of '{options.service}'"
                             f"{did_you_mean(options.service, names)}; one of {', '.join(names)}")
        files = [directory.log_of(options.service)]
    if options.follow:
        os.execv("/usr/bin/tail", ["tail", "-n", str(options.lines), "-F", *map(str, files)])
    for file in files:
        if len(files) > 1:
            print(f"==> {shown(file)} <==")
        print("\n".join(last_lines(file, options.lines)))
    return EXIT_OK
