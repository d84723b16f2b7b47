"""The command line of `scarab`."""

import argparse
import sys
from types import ModuleType
from typing import List, Sequence

from . import (completion_verb, doctor_verb, experiment_verb, logs_verb, operator_verbs, run_verb,
               sim_verb, status_verb, up_verb)
from .calibrate_words import OWN_OPTIONS, calibrate_words
from .config_words import answer_config
from .failure import EXIT_FAILURE, Failure, Interrupted
from .places import Places, default_bin, default_runs, default_stack_file
from .stack_options import add_device_options, add_profile_option, bounded_integer
from .tool_verbs import bus_of, hand_on
from .tool_words import emulator_words, log_words, topic_words
from .verbs import Verbs

_EXAMPLES = """deploy/scarab run --height 0.10 --strategy soft+hard --seed 1
deploy/scarab up && deploy/scarab run --trials 3 && deploy/scarab down
deploy/scarab experiment obstacle
deploy/scarab topic list"""


def main(words: Sequence[str]) -> int:
    """Runs the verb; the exit code of the program."""
    try:
        return _dispatch(list(words))
    except Interrupted as stop:
        print(f"scarab: {stop}", file=sys.stderr)
        return stop.exit_code
    except Failure as failure:
        print(f"{failure}" if failure.exit_code == 2 else f"scarab: {failure}", file=sys.stderr)
        return failure.exit_code
    except BrokenPipeError:  # such as `scarab logs | head`
        sys.stderr.close()
        return EXIT_FAILURE
    except OSError as error:  # such as a disk that is full
        print(f"scarab: {error.strerror}: {error.filename}" if error.filename else f"scarab: {error}",
              file=sys.stderr)
        return EXIT_FAILURE


def all_verbs() -> Verbs:
    verbs = Verbs()
    verbs.group("the stack")
    up_verb.add_verbs(verbs)
    _add_status(verbs)
    _add_logs(verbs)
    _add_doctor(verbs)
    verbs.group("trials")
    run_verb.add_verb(verbs)
    sim_verb.add_verb(verbs)
    experiment_verb.add_verb(verbs)
    verbs.add_tool("search", "scarab-search", "search for parameters: run, evaluate, write")
    verbs.group("the robot, while a trial runs")
    operator_verbs.add_verbs(verbs)
    verbs.group("a real robot, in place of the simulated one")
    verbs.add_tool("calibrate", "scarab-calibrate",
                   "find how a robot's servos sit in its joints; write its calibration file",
                   read=calibrate_words, own=OWN_OPTIONS)
    verbs.add_tool("emulator", "scarab-emulator", "emulate a robot's boards; tell the emulator to misbehave",
                   read=emulator_words)
    verbs.group("looking on, and files")
    verbs.add_tool("topic", "scarab-topic", "list, echo, measure and publish the topics of any DDS system",
                   bus_of, topic_words)
    verbs.add_tool("log", "scarab-log", "read logs: info, cat, export, diff, recover, replay, ...",
                   read=log_words)
    verbs.add_tool("config", "scarab-config", "check, dump and compare configuration files")
    completion_verb.add_verb(verbs)
    verbs.finish(_EXAMPLES)
    return verbs


def _dispatch(words: List[str]) -> int:
    verbs = all_verbs()
    places = Places(default_bin(), default_runs(), default_stack_file())
    if words and words[0] == completion_verb.ASK:
        return completion_verb.answer(words[1:], verbs, places)
    if words[:1] == ["config"]:
        code = answer_config(words[1:], places)
        if code is not None:
            return code
    if words and words[0] in verbs.tools:  # their options are theirs to read
        return hand_on(verbs.tools[words[0]], words[1:], places)
    options = verbs.parse(words)
    return options.verb(options, Places(options.bin, options.runs, options.stack))


def _add_status(verbs: Verbs) -> None:
    parser = verbs.add("status", status_verb.status,
                       "show the processes and services of the running stacks",
                       "deploy/scarab status\ndeploy/scarab status --watch")
    _add_own_options(status_verb, parser)


def _add_logs(verbs: Verbs) -> None:
    parser = verbs.add("logs", logs_verb.logs,
                       "show what the services of the running or last stack wrote",
                       "deploy/scarab logs premotor -f", operands=" [SERVICE]")
    parser.add_argument("service", nargs="?", metavar="SERVICE",
                        help="one of them, or launcher (all)")
    parser.add_argument("-f", "--follow", action="store_true", help="go on showing new lines")
    parser.add_argument("-n", "--lines", type=bounded_integer(1, 1000000), default=40, metavar="N",
                        help="how many lines of each (40)")


def _add_doctor(verbs: Verbs) -> None:
    parser = verbs.add("doctor", doctor_verb.doctor,
                       "look for what keeps a stack from running, and say what to do",
                       "deploy/scarab doctor\ndeploy/scarab doctor sides endpoints --domain 4\n"
                       "deploy/scarab doctor device realtime --profile robot",
                       operands=" [CHECK...]")
    add_profile_option(parser)
    parser.set_defaults(profile=None)  # known whether it was given: a stack that runs has its own
    add_device_options(parser)
    _add_own_options(doctor_verb, parser)


def _add_own_options(verb: ModuleType, parser: argparse.ArgumentParser) -> None:
    """Options that the verb's own file declares."""
    add_options = getattr(verb, "add_options", None)
    if add_options is not None:
        add_options(parser)
