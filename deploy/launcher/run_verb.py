"""`scarab run`: a series of trials on a running or a fresh stack."""

import argparse
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import Iterator, List, Optional

from .domain_claim import claim_domain
from .failure import Failure, Interrupted
from .figure import draw_figure, first_trial
from .foreground import run_in_front
from .keeper_process import Event, KeeperLine
from .launch import event_line, launch
from .places import Places, shown
from .run_directory import RunDirectory, create_run_directory
from .running_stack import Kind, RunningStack, running_stacks
from .signals import Signals
from .stack import Bus
from .stack_file import read_stack
from .trial_lock import TrialLock
from .trial_options import check_trial, trial_arguments


def run(options: argparse.Namespace, places: Places) -> int:
    """Exit code of the experiment: 0 if all trials succeeded."""
    signals = Signals()
    stack = read_stack(places.stack_file, options.profile, places.root)
    check_trial(options, stack)
    places.program("scarab-experiment")
    running = _lasting_stack(places.runs, options.domain)
    if running is not None:
        return _run_on(running, options, places, signals)
    claim = claim_domain(options.domain)
    kind = Kind.LASTING if options.keep else Kind.RUN
    tag = stack.tag if options.tag is None else options.tag
    launched = launch(places, stack, claim, tag, kind, signals)
    try:
        with _stopped_in_the_end(launched.keeper, signals, options.keep), \
                _only_trials_of(launched.directory):
            code = _experiment(options, places, launched.bus, stack.expected(),
                               launched.directory, signals, launched.keeper)
        if not options.keep:
            _mend_log(places, launched.directory, signals)
        _figure(places, launched.directory, launched.directory, signals)
    finally:
        _say_where(launched.directory, launched.directory)
    if options.keep:
        print("the stack is still running: stop it with `deploy/scarab down`")
    return code


def _run_on(running: RunningStack, options: argparse.Namespace, places: Places,
            signals: Signals) -> int:
    """On a stack that `up` started: it goes on running afterwards."""
    with _only_trials_of(running.directory):
        directory = create_run_directory(places.runs)
        (directory.path / "stack").symlink_to(Path("..") / running.directory.path.name)
        print(f"using the running stack of {shown(running.directory.path)} "
              f"(DDS domain {running.bus.domain})")
        try:
            code = _experiment(options, places, running.bus, running.expected, directory, signals,
                               None)
            _figure(places, directory, running.directory, signals)
        finally:
            _say_where(directory, running.directory)
        return code


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
                directory: RunDirectory, signals: Signals,
                keeper: Optional[KeeperLine]) -> int:
    command = [str(places.program("scarab-experiment")), *bus.arguments(), "--expect", expected,
               *trial_arguments(options), "--results", str(directory.results)]

    def watch() -> bool:
        _tell(keeper.events(signals))
        return not keeper.ended

    code = run_in_front(command, signals, watch=watch if keeper else None)
    if keeper is not None and keeper.ended:
        raise Failure(f"the keeper of the stack ended in the middle of the run; see "
                      f"{shown(directory.log_of('launcher'))}")
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
