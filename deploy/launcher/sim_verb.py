"""`scarab sim`: trials with the cores of all services in one process."""

import argparse
from typing import Dict, List, NoReturn

from .failure import UsageError
from .places import Places, shown
from .preflight import check_configuration, resolved_configuration, write_configuration
from .run_directory import create_run_directory
from .run_record import record_simulation, source_version
from .stack import Stack
from .stack_file import read_stack
from .stack_options import DEFAULT_PROFILE, add_data_options, changes_of
from .strategies import check_strategy, strategies_of
from .tool_verbs import become
from .trial_options import add_trial_options, check_trial, trial_arguments
from .trial_row import fill_from_row, note_other_configuration
from .verbs import Verbs

_SIMULATED = ("plant", "premotor", "supervisor")
_MORE = """The same samples as of a stack in lockstep, byte for byte, without DDS: for many trials, and for a
debugger. It writes its log to a new run directory, or to --output."""
_EXAMPLES = """deploy/scarab sim --height 0.08 --seed 3
deploy/scarab sim --trials 20 --robot beetle --results table.csv
deploy/scarab sim --row runs/experiments/obstacle/results.csv:17"""


def add_verb(verbs: Verbs) -> None:
    parser = verbs.add("sim", simulate, "run trials with the same cores in one process, without DDS",
                       _EXAMPLES, _MORE, of_stack=False)
    add_data_options(parser)
    add_trial_options(parser)
    parser.add_argument("--output", metavar="FILE",
                        help="record all samples here (trial.mcap in a new run directory)")
    parser.add_argument("--results", metavar="FILE", help="write a table of the trials here (CSV)")
    parser.add_argument("--quiet", action="store_true", help="print results only")


def simulate(options: argparse.Namespace, places: Places) -> NoReturn:
    """Becomes scarab-sim with the files of the stack's profile `sim`."""
    stack = read_stack(places.stack_file, DEFAULT_PROFILE, places.root, changes_of(options))
    fill_from_row(options)
    check_trial(options)
    if options.strategy is not None:
        check_strategy(options.strategy, strategies_of(stack, places))
    note_other_configuration(options, stack, places)
    command = [str(places.program("scarab-sim")), *_configuration(stack), *trial_arguments(options)]
    outputs = {"--output": options.output, "--results": options.results}
    if options.output is None:
        outputs = {**outputs, **_run_directory(stack, options, places)}
    for option, file in outputs.items():
        command += [option, str(file)] if file is not None else []
    become(command + (["--quiet"] if options.quiet else []))


def _run_directory(stack: Stack, options: argparse.Namespace, places: Places) -> Dict[str, object]:
    """Makes one and says where; the outputs that go there."""
    cores = stack.only(_SIMULATED)
    check_configuration(places, cores)
    texts = resolved_configuration(places, cores)
    directory = create_run_directory(places.runs)
    write_configuration(directory, cores, texts)
    record_simulation(cores, directory, source_version(places.root))
    print(f"run: {shown(directory.path)}")
    return {"--output": directory.path / "trial.mcap",
            "--results": options.results or directory.results}


def _configuration(stack: Stack) -> List[str]:
    arguments: List[str] = []
    for name in _SIMULATED:
        service = stack.service(name)
        if service is None or service.config is None:
            raise UsageError(f"{stack.file}: `scarab sim` needs the config of service '{name}'")
        arguments += [f"--{name}", str(service.config)]
        if service.robot and "--robot" not in arguments:
            arguments += ["--robot", str(service.robot)]
    return arguments
