"""`scarab doctor`: looks for what would keep a stack from running, and says what to do about it."""

import argparse
import json
import sys
from typing import Callable, Iterator, List, Sequence, Tuple

from .colour import Colour
from .doctor.device import device
from .doctor.domain import domain, ports
from .doctor.endpoints import endpoints
from .doctor.environment import environment
from .doctor.finding import Finding, Level
from .doctor.installation import configuration, programs
from .doctor.leftovers import leftovers
from .doctor.network import network
from .doctor.packages import figures, packages
from .doctor.realtime import realtime
from .doctor.services import care, clock
from .doctor.sides import sides
from .doctor.storage import storage
from .doctor.subject import Subject
from .failure import EXIT_FAILURE, EXIT_OK
from .places import Places
from .strict_yaml import did_you_mean

Check = Callable[[Subject], List[Finding]]
_CHECKS: Tuple[Tuple[str, Check], ...] = (
    ("packages", packages),
    ("programs", programs),
    ("configuration", configuration),
    ("figures", figures),
    ("storage", storage),
    ("environment", environment),
    ("leftovers", leftovers),
    ("network", network),
    ("domain", domain),
    ("ports", ports),
    ("sides", sides),
    ("endpoints", endpoints),
    ("clock", clock),
    ("device", device),
    ("realtime", realtime),
    ("realtime", care),
)
_ALL = "all"
_COLUMN = 15
_PAINT = {Level.OK: "green", Level.NOTE: "yellow", Level.PROBLEM: "red"}


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("checks", nargs="*", metavar="CHECK", type=_check_name, default=_ALL,
                        choices=[*_names(), _ALL], help=f"only these: {', '.join(_names())} (all)")
    parser.add_argument("--json", action="store_true",
                        help="one JSON document: healthy, findings (check, level, what, advice)")


def doctor(options: argparse.Namespace, places: Places) -> int:
    """1 if a problem was found; UsageError for a profile that is not there."""
    checks = [(name, check) for name, check in _CHECKS
              if _ALL in options.checks or name in options.checks]
    subject = Subject(options, places)
    found = []
    for name, finding in _findings(checks, subject):
        found.append((name, finding))
        if not options.json:
            _print(name, finding)
    problems = sum(f.level is Level.PROBLEM for _, f in found)
    if options.json:
        print(json.dumps({"healthy": problems == 0, "findings": [
            {"check": name, "level": f.level.value, "what": f.what, "advice": f.advice}
            for name, f in found]}, indent=1))
    else:
        print(_sum(problems, sum(f.level is Level.NOTE for _, f in found)))
    return EXIT_FAILURE if problems else EXIT_OK


def _names() -> List[str]:
    return list(dict.fromkeys(name for name, _ in _CHECKS))


def _check_name(text: str) -> str:
    """An argparse type."""
    if text not in (*_names(), _ALL):
        raise argparse.ArgumentTypeError(f"there is no check '{text}'{did_you_mean(text, _names())}")
    return text


def _findings(checks: Sequence[Tuple[str, Check]],
              subject: Subject) -> Iterator[Tuple[str, Finding]]:
    for name, check in checks:
        with _Progress(name):
            findings = check(subject)
        for finding in findings:
            yield name, finding


def _print(name: str, finding: Finding) -> None:
    colour = Colour(sys.stdout)
    level = colour.paint(f"{_shown(finding.level):8}", _PAINT[finding.level])
    print(f"{level}{name:{_COLUMN}}{finding.what}", flush=True)
    if finding.advice:
        print(f"{'':{8 + _COLUMN}}{finding.advice}", flush=True)


def _shown(level: Level) -> str:
    return level.value.upper() if level is Level.PROBLEM else level.value


def _sum(problems: int, notes: int) -> str:
    beside = f", {notes} note{'s' * (notes != 1)}" if notes else ""
    return f"{problems or 'no'} problem{'s' * (problems != 1)}{beside}"


class _Progress:
    """Says on a terminal what is being looked at; nothing stays of it."""

    def __init__(self, name: str):
        self._name = name
        self._terminal = sys.stderr.isatty()

    def __enter__(self) -> None:
        if self._terminal:
            print(f"looking at: {self._name} ...", end="\r", file=sys.stderr, flush=True)

    def __exit__(self, *_: object) -> None:
        if self._terminal:
            print("\033[K", end="", file=sys.stderr, flush=True)
