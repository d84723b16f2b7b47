"""Trials on a stack that is ready: the experiment in front, the keeper's events beside it."""

import argparse
import sys
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Iterator, List

from .failure import Failure, Interrupted
from .foreground import run_in_front
from .keeper_events import Event, KeeperEvents, event_line
from .keeper_process import KeeperLine
from .places import Places
from .process_identity import write_text
from .run_directory import RunDirectory
from .signals import Signals
from .stack import Bus
from .trial_lock import TrialLock
from .trial_options import trial_arguments


@contextmanager
def only_trials_of(stack_directory: RunDirectory) -> Iterator[None]:
    """Nobody else runs trials on the stack meanwhile, and its keeper knows that some run."""
    lock = TrialLock.try_take(stack_directory.trial_lock)
    if lock is None:
        raise Failure("trials are already running on this stack; wait for their end, or start "
                      "a stack of your own with --domain N")
    try:
        yield
    finally:
        lock.release()


@dataclass(frozen=True)
class Stage:
    """The stack that trials run on."""

    bus: Bus
    expected: str
    tick_master: str  # the service whose end no trial survives; empty where it runs elsewhere
    keeper: KeeperEvents


def conduct(options: argparse.Namespace, places: Places, stage: Stage, directory: RunDirectory,
            signals: Signals) -> int:
    """Runs the trials that the options ask for; the exit code of the experiment.

    Failure where the stack goes down meanwhile, Interrupted on a request to stop.
    """
    fault_file = directory.path / ".fault"
    command = [str(places.program("scarab-experiment")), *stage.bus.arguments(),
               "--expect", stage.expected, *trial_arguments(options),
               "--results", str(directory.results), "--fault-file", str(fault_file)]

    def watch() -> bool:
        for event in stage.keeper.events(signals):
            _tell([event])
            if event.get("service") == stage.tick_master and event["event"] in ("crashed", "lost"):
                write_text(fault_file, f"{stage.tick_master} {event['text']}")
        return not stage.keeper.ended

    try:
        code = run_in_front(command, signals, watch=watch)
    finally:
        fault_file.unlink(missing_ok=True)
    if stage.keeper.ended:
        raise Failure("the stack was stopped in the middle of the run, or its keeper has died; see "
                      "`deploy/scarab logs launcher`")
    if code < 0:
        raise Failure(f"scarab-experiment was ended by signal {-code}")
    return code


@contextmanager
def stopped_in_the_end(keeper: KeeperLine, signals: Signals, keep: bool) -> Iterator[None]:
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
