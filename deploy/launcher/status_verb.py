"""`scarab status`: what runs, and how it is."""

import argparse
import sys

from .failure import EXIT_FAILURE, EXIT_OK
from .places import Places
from .signals import Signals
from .status.onlooker import Onlooker
from .status.screen import Screen
from .status.show import shown_as

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
