"""One call of the launcher that works at an experiment: from its plan to its report."""

import shlex
import sys
import time
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Iterator, List, Optional

from ..failure import Failure, Interrupted, UsageError
from ..places import Places, shown
from ..process_identity import write_text
from ..signals import Signals
from .backend import Backend
from .configuration import Configuration
from .directory import ExperimentDirectory
from .dispatch import Dispatch
from .estimate import Estimate, duration
from .journal import Journal, read_journal
from .outcome_table import outcome_tables
from .plan import Plan, PlannedTrial, Shard
from .progress import Progress
from .record import Record, Session, make_record, read_record
from .report import draw_report, say_where
from .results import Result, table


@dataclass(frozen=True)
class Task:
    """What is to be done, and where."""

    plan: Plan
    shard: Shard
    configuration: Configuration
    command: str  # the exact one
    version: str
    directory: ExperimentDirectory


def check_directory(task: Task) -> None:
    """UsageError where something else lies there than the beginning of this task."""
    _record_of(task)


def work(task: Task, backend: Backend, places: Places, signals: Signals, fresh: bool,
         with_report: bool) -> None:
    """Runs what has not been run yet, and draws the report if it should. Failure where a trial cannot be
    run, Interrupted on a request to stop: everything so far is kept, and another call goes on."""
    directory = task.directory
    with directory.alone():
        if fresh:
            directory.clear()
        record = _record_of(task)
        directory.logs.mkdir(exist_ok=True)
        task.configuration.write(directory.config)
        record.write(directory)
        trials = record.own_trials()
        done = read_journal(directory.journal, trials)
        left = _left(trials, done)
        _say_what_comes(record, len(done), len(left), backend, directory)
        if left:
            _run(task, record, backend, done, left, places, signals)
        _finish(task, record, with_report, places, signals)


def _record_of(task: Task) -> Record:
    """The one that lies there, with the words of today; or a new one."""
    wanted = make_record(task.plan, task.shard, task.configuration.robot, task.configuration.digest(),
                         task.command, task.version)
    found = read_record(task.directory)
    if found is None:
        return wanted
    where = shown(task.directory.path)
    what_to_do = "--fresh starts over there, --out DIR keeps both"
    difference = found.difference_to(wanted)
    if difference is not None:
        raise UsageError(f"{where} holds another plan: {difference}; {what_to_do}")
    if found.configuration != wanted.configuration:
        files = task.configuration.files_that_differ(task.directory.config)
        raise UsageError(f"{where} was run with another configuration: {', '.join(files) or 'its config/'} "
                         f"({found.configuration}, now {wanted.configuration}); {what_to_do}")
    wanted.sessions, wanted.command = found.sessions, found.command
    wanted.version = found.version
    return wanted


def _left(trials: List[PlannedTrial], done: List[Result]) -> List[PlannedTrial]:
    """Those that have no result; the first of each cell first, for an early picture of all cells."""
    finished = {result.trial.index for result in done}
    return sorted((t for t in trials if t.index not in finished), key=lambda t: (t.seed, t.index))


def _say_what_comes(record: Record, done: int, left: int, backend: Backend,
                    directory: ExperimentDirectory) -> None:
    name = f"{record.name}, shard {record.shard}" if record.shard else record.name
    where = f"results go to {shown(directory.path)}"
    if not left:
        print(f"{name}: {_trials(done)}, all of which have been run", flush=True)
    elif done:
        print(f"{name}: going on with {left} of {done + left} trials, {backend.words}; {where}", flush=True)
    else:
        print(f"{name}: {_trials(left)}, {backend.words}; {where}", flush=True)


def _run(task: Task, record: Record, backend: Backend, done: List[Result], left: List[PlannedTrial],
         places: Places, signals: Signals) -> None:
    directory = task.directory
    session = Session(shlex.join(["deploy/scarab", *sys.argv[1:]]), task.version, backend.words)
    record.sessions.append(session)
    record.version = ", ".join(dict.fromkeys(s.version for s in record.sessions))
    record.write(directory)
    seats = backend.seats(places, directory, record.recorded, signals)
    estimate = Estimate(done, left, time.monotonic)
    progress = Progress(record.name, len(done) + len(left), done, estimate, sys.stderr)

    def listen(result: Optional[Result]) -> None:
        if result is not None:
            estimate.add(result)
            progress.add(result)
        progress.show()

    journal = Journal(directory.journal)
    try:
        with _saying_what_is_kept(progress, directory):
            Dispatch(seats, left, journal, listen, signals).run()
    finally:
        journal.close()
        progress.finish()
        session.trials = progress.done - len(done)
        session.wall_s = round(estimate.elapsed_s, 3)
        session.simulated_s = round(estimate.simulated_s, 3)
        record.write(directory)
        _write_results(directory, record)
    print(f"{_trials(session.trials)}, {session.simulated_s:.0f} s of simulated time, in "
          f"{duration(session.wall_s)} ({estimate.speed or 0:.0f} x real time)")


@contextmanager
def _saying_what_is_kept(progress: Progress, directory: ExperimentDirectory) -> Iterator[None]:
    """Of an end in the middle."""
    try:
        yield
    except Interrupted:
        raise Interrupted(f"interrupted after {progress.done} of {progress.total} trials; the same command "
                          "goes on from there") from None
    except Failure as failure:
        raise Failure(f"{failure}\n{progress.done} of {progress.total} trials are kept in "
                      f"{shown(directory.path)}, from which the same command goes on; what the workers "
                      f"wrote is in {shown(directory.logs)}") from None


def _finish(task: Task, record: Record, with_report: bool, places: Places,
            signals: Signals) -> None:
    results = _write_results(task.directory, record)
    print(f"\n{outcome_tables(task.plan, results)}\n", flush=True)
    if record.shard:
        print(f"when all {record.the_shard().of} shards are there: "
              "deploy/scarab experiment merge DIR... --out DIR")
    elif with_report:
        draw_report(places, task.directory.path, signals)
    say_where(task.directory.path)


def _trials(count: int) -> str:
    return "1 trial" if count == 1 else f"{count} trials"


def _write_results(directory: ExperimentDirectory, record: Record) -> List[Result]:
    results = read_journal(directory.journal, record.own_trials())
    write_text(directory.results, table(results, record.configuration).rstrip("\n"))
    return results
