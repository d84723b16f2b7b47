"""`scarab run`: a series of trials on a running or a fresh stack."""

import argparse
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import Iterator, List, Optional

from .domain_claim import claim_domain
from .failure import Failure, Interrupted, UsageError
from .figure import draw_figure, first_trial
from .foreground import run_in_front
from .keeper_events import Event, EventTail, KeeperEvents, event_line
from .keeper_process import KeeperLine
from .launch import launch
from .places import Places, shown
from .process_identity import write_text
from .run_directory import RunDirectory, create_run_directory
from .run_record import record_trials, source_version
from .running_stack import Kind, RunningStack, running_stacks
from .signals import Signals
from .stack import Bus, Pace
from .stack_file import read_stack
from .stack_options import DEFAULT_PROFILE, add_pace_options, add_stack_options, changes_of
from .strategies import check_strategy, strategies_of, strategies_of_running
from .trial_lock import TrialLock
from .trial_options import add_trial_options, check_trial, trial_arguments
from .verbs import Verbs

_MORE = """It uses the stack that is up, at that stack's pace, and leaves it up; without one it starts a stack
for this run and stops it afterwards. The log, the results and a figure are left in runs/latest."""
_EXAMPLES = """deploy/scarab run --height 0.08 --strategy boxing+hard --seed 3
deploy/scarab run --trials 10 --replicas premotor=2
deploy/scarab run --realtime --config plant=my-plant.yaml"""


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
    if options.strategy is not None:
        check_strategy(options.strategy, strategies_of(stack, places))
    # The other host of a divided stack has to know the domain beforehand.
    wanted = 0 if options.domain is None and stack.elsewhere else options.domain
    kind = Kind.LASTING if options.keep else Kind.RUN
    launched = launch(places, stack, claim_domain(wanted), options.pace or Pace.LOCKSTEP, kind,
                      signals)
    bus, directory = launched.run.bus, launched.run.directory
    master = stack.tick_master()
    try:
        with _stopped_in_the_end(launched.keeper, signals, options.keep), \
                _only_trials_of(directory):
            code = _experiment(options, places, bus, stack.expected(), directory, signals,
                               launched.keeper, master.name if master else "")
        if not options.keep:
            _mend_log(places, directory, signals)
        if not options.no_figure:
            _figure(places, directory, directory, signals)
    finally:
        _say_where(directory, directory)
    if options.keep:
        print("the stack is still running: stop it with `deploy/scarab down`")
    return code


def _run_on(running: RunningStack, options: argparse.Namespace, places: Places,
            signals: Signals) -> int:
    """On a stack that `up` started: it goes on running afterwards."""
    _check_fits(options, running)
    check_strategy(options.strategy, strategies_of_running(running))
    with _only_trials_of(running.directory):
        directory = create_run_directory(places.runs)
        (directory.path / "stack").symlink_to(Path("..") / running.directory.path.name)
        record_trials(directory, running.directory, source_version(places.root))
        print(f"using the stack of {shown(running.directory.path)} that is up "
              f"(DDS domain {running.bus.domain}, {running.pace.words})")
        try:
            code = _experiment(options, places, running.bus, running.expected, directory, signals,
                               EventTail(running), running.tick_master)
            if not options.no_figure:
                _figure(places, directory, running.directory, signals)
        finally:
            _say_where(directory, running.directory)
        return code


def _check_fits(options: argparse.Namespace, running: RunningStack) -> None:
    """UsageError for options that want the stack which is up to be another one."""
    if options.pace not in (None, running.pace):
        raise UsageError(f"--{options.pace.value}: the stack that is up goes {running.pace.words}. "
                         f"Leave the option out, or start it anew: deploy/scarab down && "
                         f"deploy/scarab up --{options.pace.value}")
    other = {"--profile": options.profile, "--replicas": options.replicas,
             "--robot": options.robot, "--config": options.config,
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


@contextmanager
def _only_trials_of(stack_directory: RunDirectory) -> Iterator[None]:
    """Nobody else runs trials on the stack meanwhile, and its keeper knows that some run."""
    lock = TrialLock.try_take(stack_directory.trial_lock)
    if lock is None:
        raise Failure("trials are already running on this stack; wait for their end, or start "
                      "a stack of your own with --domain N")
    try:
        yield
    finally:
        lock.release()


def _experiment(options: argparse.Namespace, places: Places, bus: Bus, expected: str,
                directory: RunDirectory, signals: Signals, keeper: KeeperEvents,
                tick_master: str) -> int:
    fault_file = directory.path / ".fault"
    command = [str(places.program("scarab-experiment")), *bus.arguments(), "--expect", expected,
               *trial_arguments(options), "--results", str(directory.results),
               "--fault-file", str(fault_file)]

    def watch() -> bool:
        for event in keeper.events(signals):
            _tell([event])
            if event.get("service") == tick_master and event["event"] in ("crashed", "lost"):
                write_text(fault_file, f"{tick_master} {event['text']}")  # nothing can save the trial
        return not keeper.ended

    try:
        code = run_in_front(command, signals, watch=watch)
    finally:
        fault_file.unlink(missing_ok=True)
    if keeper.ended:
        raise Failure("the stack was stopped in the middle of the run, or its keeper has died; see "
                      "`deploy/scarab logs launcher`")
    if code < 0:
        raise Failure(f"scarab-experiment was ended by signal {-code}")
    return code


@contextmanager
def _stopped_in_the_end(keeper: KeeperLine, signals: Signals, keep: bool) -> Iterator[None]:
    """Whatever happens inside, the stack is stopped; with `keep` only if something happens."""
    try:
        yield
    except BaseException as error:
        if isinstance(error, Interrupted):
            print("\nscarab: stopping the stack", file=sys.stderr, flush=True)
        _tell(keeper.stop(signals))
        raise
    if keep:
        keeper.let_go()
    else:
        _tell(keeper.stop(signals))


def _tell(events: List[Event]) -> None:
    for line in filter(None, map(event_line, events)):
        print(f"\nscarab: {line}", file=sys.stderr, flush=True)


def _log_of(stack_directory: RunDirectory) -> Path:
    closed = stack_directory.path / "trial.mcap"
    return closed if closed.exists() else closed.with_name("trial.mcap.active")


def _mend_log(places: Places, directory: RunDirectory, signals: Signals) -> None:
    """A logger that was killed leaves its file open: what is whole in it becomes the log."""
    closed = directory.path / "trial.mcap"
    active = closed.with_name("trial.mcap.active")
    if active.exists() and not closed.exists():
        code = run_in_front([places.program("scarab-log"), "recover", active, closed], signals)
        print(f"scarab: the logger did not close {active.name}; scarab-log recover "
              f"{'made ' + closed.name + ' of it' if code == 0 else 'failed'}", file=sys.stderr)


def _figure(places: Places, directory: RunDirectory, stack_directory: RunDirectory,
            signals: Signals) -> None:
    try:
        draw_figure(places, _log_of(stack_directory), first_trial(directory.results),
                    directory.path / "figure7", signals)
    except Interrupted:
        raise
    except Failure as failure:
        print(f"scarab: figure 7 could not be drawn: {failure}", file=sys.stderr)


def _say_where(directory: RunDirectory, stack_directory: RunDirectory) -> None:
    log = _log_of(stack_directory)
    things = [("run", directory.path), ("log", log), ("results", directory.results),
              ("figure", directory.path / "figure7.svg"), ("", directory.path / "figure7.png"),
              ("configuration", stack_directory.config)]
    for name, path in things:
        if path.exists():
            print(f"{name + ':' if name else '':15}{shown(path)}")
