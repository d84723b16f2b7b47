"""The command line of `scarab`."""

import argparse
import sys
from pathlib import Path
from typing import List, Sequence

from .doctor_verb import doctor
from .failure import EXIT_FAILURE, Failure, Interrupted
from .places import Places, default_bin, default_runs, default_stack_file
from .run_verb import run
from .status_verb import logs, status
from .tool_verbs import hand_on, simulate
from .trial_options import add_trial_options, bounded_integer
from .up_verb import down, up

_TOOLS = {
    "topic": ("scarab-topic", "list and echo topics of any DDS system: topic list, topic echo T"),
    "log": ("scarab-log", "read logs: log info FILE, log csv FILE --topic T, compare, recover"),
    "operator": ("scarab-operator", "tell the running stack: pause, start, step, stop, ..."),
    "sim": ("scarab-sim", "trials with the same cores in one process, without DDS"),
}
_NEEDS_BUS = ("topic", "operator")

_EPILOG = """exit codes: 0 success, 1 failure, 2 bad usage or configuration (nothing was started),
130 interrupted. `deploy/scarab VERB --help` shows the options of a verb.

examples:
  deploy/scarab run --height 0.10 --strategy soft+hard --seed 1
  deploy/scarab up && deploy/scarab run --trials 3 && deploy/scarab down
  deploy/scarab topic list
"""


def main(words: Sequence[str]) -> int:
    """Runs the verb; the exit code of the program."""
    try:
        return _dispatch(list(words))
    except Interrupted as stop:
        print("scarab: interrupted", file=sys.stderr)
        return stop.exit_code
    except Failure as failure:
        print(f"{failure}" if failure.exit_code == 2 else f"scarab: {failure}", file=sys.stderr)
        return failure.exit_code
    except BrokenPipeError:  # such as `scarab logs | head`
        sys.stderr.close()
        return EXIT_FAILURE


def _dispatch(words: List[str]) -> int:
    if words and words[0] in _TOOLS:  # their options are theirs to read
        places = Places(default_bin(), default_runs(), default_stack_file())
        if words[0] == "sim":
            return simulate(words[1:], places)
        return hand_on(_TOOLS[words[0]][0], words[1:], places, words[0] in _NEEDS_BUS)
    options = _parser().parse_args(words)
    return options.verb(options, Places(options.bin, options.runs, options.stack))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="scarab", epilog=_EPILOG, allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Starts, watches and stops the Scarab stack, and runs trials on it.")
    verbs = parser.add_subparsers(title="verbs", metavar="VERB", required=True)
    _add_run(verbs)
    _add_up(verbs)
    _verb(verbs, "down", down, "stop a running stack, the logger last")
    _verb(verbs, "status", status, "processes and services of the running stacks")
    _add_logs(verbs)
    parent = _verb(verbs, "doctor", doctor, "look for what keeps a stack from running")
    _add_profile(parent)
    for name, (_, text) in _TOOLS.items():
        verbs.add_parser(name, help=text, add_help=False)
    return parser


def _verb(verbs, name: str, function, text: str) -> argparse.ArgumentParser:
    parser = verbs.add_parser(name, help=text, description=text[0].upper() + text[1:] + ".",
                              allow_abbrev=False)
    parser.set_defaults(verb=function)
    stack = parser.add_argument_group("stack")
    stack.add_argument("--domain", type=bounded_integer(0, 230), metavar="N",
                       help="DDS domain of the stack")
    stack.add_argument("--stack", type=Path, metavar="FILE", default=default_stack_file(),
                       help="description of the stack (deploy/stack.yaml)")
    stack.add_argument("--bin", type=Path, metavar="DIR", default=default_bin(),
                       help="compiled programs (build/release/bin)")
    stack.add_argument("--runs", type=Path, metavar="DIR", default=default_runs(),
                       help="where the run directories are (runs)")
    return parser


def _add_profile(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--profile", default="sim", metavar="NAME",
                        help="which services: sim, or robot with the bridge in the plant's place (sim)")


def _add_run(verbs) -> None:
    parser = _verb(verbs, "run", run, "run trials on the running stack, or on one for this run only")
    _add_profile(parser)
    parser.add_argument("--tag", metavar="TEXT", help="discovery tag of a stack started for this run")
    parser.add_argument("--keep", action="store_true", help="leave the stack running afterwards")
    add_trial_options(parser)


def _add_up(verbs) -> None:
    parser = _verb(verbs, "up", up, "start a stack that stays, and wait until it is ready")
    _add_profile(parser)
    parser.add_argument("--tag", metavar="TEXT", help="discovery tag of Cyclone DDS (none)")


def _add_logs(verbs) -> None:
    parser = _verb(verbs, "logs", logs, "show what the services of the running or last stack wrote")
    parser.add_argument("service", nargs="?", metavar="SERVICE", help="one of them (all)")
    parser.add_argument("-f", "--follow", action="store_true", help="go on showing new lines")
    parser.add_argument("-n", "--lines", type=bounded_integer(1, 1000000), default=40, metavar="N",
                        help="how many lines of each (40)")
