"""`scarab run`: a series of trials on a running or a fresh stack."""

import argparse
from pathlib import Path
from typing import List, Optional

from .domain_claim import claim_domain
from .experiment import Stage, conduct, only_trials_of, stopped_in_the_end
from .failure import Failure, UsageError
from .keeper_events import EventTail
from .launch import launch
from .log_losses import log_losses
from .pace_choice import choose_pace
from .places import Places, shown
from .run_directory import create_run_directory
from .run_record import record_trials, source_version
from .run_results import figure_of, mend_log, say_where
from .running_stack import Kind, RunningStack, running_stacks
from .signals import Signals
from .stack import LOGGER, Pace
from .stack_file import read_stack
from .stack_options import DEFAULT_PROFILE, add_pace_options, add_stack_options, changes_of
from .strategies import check_strategy, strategies_of, strategies_of_running
from .trial_options import add_trial_options, check_trial
from .trial_row import fill_from_row, note_other_configuration
from .verbs import Verbs

_MORE = """It uses the stack that is up, at that stack's pace, and leaves it up; without one it starts a stack
for this run and stops it afterwards. The log, the results and a figure are left in runs/latest."""
_EXAMPLES = """deploy/scarab run --height 0.08 --strategy boxing+hard --seed 3
deploy/scarab run --trials 10 --replicas premotor=2
deploy/scarab run --row runs/experiments/obstacle/results.csv:17 --realtime
deploy/scarab run --realtime --config plant=my-plant.yaml
deploy/scarab run --profile robot --driver dynamixel --emulated"""


def add_verb(verbs: Verbs) -> None:
    parser = verbs.add("run", run, "run trials on the stack that is up, or on one for this run only",
                       _EXAMPLES, _MORE)
    add_stack_options(parser)
    parser.set_defaults(profile=None)  # known whether it was given: a stack that is up has its own
    add_pace_options(parser, Pace.LOCKSTEP)
    parser.add_argument("--keep", action="store_true", help="leave the stack running afterwards")
    parser.add_argument("--no-figure", action="store_true", help="draw no figure of the first trial")
    add_trial_options(parser)


def run(options: argparse.Namespace, places: Places) -> int:
    """Exit code of the experiment: 0 if all trials succeeded."""
    signals = Signals()
    fill_from_row(options)
    check_trial(options)
    places.program("scarab-experiment")
    running = _lasting_stack(places.runs, options.domain)
    if running is not None:
        return _run_on(running, options, places, signals)
    return _run_on_its_own(options, places, signals)


def _run_on_its_own(options: argparse.Namespace, places: Places, signals: Signals) -> int:
    """On a stack that is started for this run."""
    stack = read_stack(places.stack_file, options.profile or DEFAULT_PROFILE, places.root,
                       changes_of(options))
    pace = choose_pace(stack, options.pace, Pace.LOCKSTEP)
    if options.strategy is not None:
        check_strategy(options.strategy, strategies_of(stack, places))
    note_other_configuration(options, stack, places)
    # The other host of a divided stack has to know the domain beforehand.
    wanted = 0 if options.domain is None and stack.elsewhere else options.domain
    kind = Kind.LASTING if options.keep else Kind.RUN
    launched = launch(places, stack, claim_domain(wanted), pace, kind, signals)
    directory, master = launched.run.directory, stack.tick_master()
    stage = Stage(launched.run.bus, stack.expected(), master.name if master else "", launched.keeper)
    lacks: List[str] = []
    try:
        with stopped_in_the_end(launched.keeper, signals, options.keep), only_trials_of(directory):
            code = conduct(options, places, stage, directory, signals)
            lacks = log_losses(places, stage.bus, stage.expected)
        if not options.keep:
            mend_log(places, directory, signals)
        if not options.no_figure:
            figure_of(places, directory, directory, LOGGER in stack.expected(), signals)
    finally:
        say_where(directory, directory, lacks)
    if options.keep:
        print("the stack is still running: stop it with `deploy/scarab down`")
    return code


def _run_on(running: RunningStack, options: argparse.Namespace, places: Places,
            signals: Signals) -> int:
    """On a stack that `up` started: it goes on running afterwards."""
    _check_fits(options, running)
    check_strategy(options.strategy, strategies_of_running(running))
    with only_trials_of(running.directory):
        directory = create_run_directory(places.runs)
        stack_directory = Path("..") / running.directory.path.name
        (directory.path / "stack").symlink_to(stack_directory)
        directory.logs.symlink_to(stack_directory / "logs")  # for `scarab logs`, when it is down again
        record_trials(directory, running.directory, source_version(places.root))
        print(f"using the stack of {shown(running.directory.path)} that is up "
              f"(DDS domain {running.bus.domain}, {running.pace.words})")
        lacks: List[str] = []
        try:
            stage = Stage(running.bus, running.expected, running.tick_master, EventTail(running))
            code = conduct(options, places, stage, directory, signals)
            lacks = log_losses(places, stage.bus, stage.expected)
            if not options.no_figure:
                figure_of(places, directory, running.directory, LOGGER in running.expected, signals)
        finally:
            say_where(directory, running.directory, lacks)
        return code


def _check_fits(options: argparse.Namespace, running: RunningStack) -> None:
    """UsageError for options that want the stack which is up to be another one."""
    if options.pace not in (None, running.pace):
        raise UsageError(f"--{options.pace.value}: the stack that is up goes {running.pace.words}. "
                         f"Leave the option out, or start it anew: deploy/scarab down && "
                         f"deploy/scarab up --{options.pace.value}")
    other = {"--profile": options.profile, "--replicas": options.replicas,
             "--robot": options.robot, "--config": options.config, "--no-log": not options.log,
             "--driver": options.driver, "--device": options.device, "--emulated": options.emulated,
             "--tag": options.tag not in (None, running.bus.tag),
             "--interface": options.interface not in (None, running.bus.interface),
             "--peers": options.peers not in (None, running.bus.peers)}
    for option, given in other.items():
        if given:
            raise UsageError(f"{option}: there is a stack up on DDS domain {running.bus.domain}, "
                             "which stays as it is. Leave the option out, stop the stack "
                             "(deploy/scarab down), or start another one with --domain N")


def _lasting_stack(runs: Path, domain: Optional[int]) -> Optional[RunningStack]:
    stacks = [s for s in running_stacks(runs)
              if s.kind is Kind.LASTING and domain in (None, s.bus.domain)]
    if not stacks:
        return None
    if not stacks[0].ready:
        raise Failure(f"the stack on DDS domain {stacks[0].bus.domain} is still starting, or is "
                      "stopping: see `deploy/scarab status`")
    return stacks[0]
