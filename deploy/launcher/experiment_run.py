"""From the words of `scarab experiment` to what is run, where and by whom."""

import argparse
import os
import shlex
from pathlib import Path
from typing import List

from .experiments.backend import Backend, InProcess, Stacks
from .experiments.configuration import Configuration, resolve_configuration
from .experiments.directory import ExperimentDirectory
from .experiments.merge import merge, name_of
from .experiments.plan import Plan
from .experiments.report import ReportFailure, write_index
from .experiments.session import Task, check_directory, work
from .failure import EXIT_OK, Failure, UsageError
from .places import Places, shown
from .run_record import source_version
from .signals import Signals
from .stack import Stack
from .stack_file import read_stack
from .stack_options import DEFAULT_PROFILE, changes_of
from .strategies import check_strategy, strategies_of


def run_plans(plans: List[Plan], options: argparse.Namespace, places: Places) -> int:
    """Each in its directory. UsageError before anything is started where one of them cannot be run as asked
    for; Failure where trials cannot be run."""
    signals = Signals()
    stack = read_stack(places.stack_file, options.profile, places.root, changes_of(options))
    _check_simulates(stack)
    backend = _backend(options, stack)
    backend.check(places)
    _check_strategies(plans, stack, places)
    configuration = resolve_configuration(places, stack)
    version = source_version(places.root)
    tasks = [_task(plan, configuration, version, options, places) for plan in plans]
    if not options.fresh:
        for task in tasks:
            check_directory(task)
    failures = _work_at_all(tasks, backend, options, places, signals)
    if failures:
        raise Failure("\n".join(map(str, failures)))
    if options.experiment == "all" and options.shard.whole and options.report:
        page = _out_of_all(options, places) / "index.html"
        write_index([task.directory.path for task in tasks], page)
        print(f"\nall of them: {shown(page)}")
    return EXIT_OK


def _work_at_all(tasks: List[Task], backend: Backend, options: argparse.Namespace, places: Places,
                 signals: Signals) -> List[ReportFailure]:
    """A report that cannot be drawn does not keep the next experiment from being run."""
    failures = []
    for task in tasks:
        signals.raise_if_stop_requested()
        if task is not tasks[0]:
            print()
        try:
            work(task, backend, places, signals, options.fresh, options.report)
        except ReportFailure as failure:
            failures.append(failure)
    return failures


def merge_shards(options: argparse.Namespace, places: Places) -> int:
    """UsageError where they make no whole."""
    signals = Signals()
    paths = [Path(directory).resolve() for directory in options.directories]
    out = options.out or places.runs / "experiments" / name_of(paths[0])
    merge(paths, out.resolve(), options.fresh, options.report, places, signals)
    return EXIT_OK


def _task(plan: Plan, configuration: Configuration, version: str, options: argparse.Namespace,
          places: Places) -> Task:
    name = plan.experiment.name
    own = name if options.shard.whole else f"{name}-shard-{options.shard.number}-of-{options.shard.of}"
    if options.experiment == "all":
        path = _out_of_all(options, places) / own
    else:
        path = options.out or places.runs / "experiments" / own
    return Task(plan, options.shard, configuration, _command(options, name), version,
                ExperimentDirectory(path.resolve()))


def _out_of_all(options: argparse.Namespace, places: Places) -> Path:
    return (options.out or places.runs / "experiments").resolve()


def _command(options: argparse.Namespace, name: str) -> str:
    """That gives the same results, wherever they then lie."""
    word = name if options.experiment in ("all", name) else options.experiment
    words = ["deploy/scarab", "experiment", word]
    words += ["--stacks", str(options.stacks)] if options.stacks else ["--inproc"]
    for option, value in (("--trials", options.trials), ("--seed", options.seed),
                          ("--robot", options.robot),
                          ("--profile", None if options.profile == DEFAULT_PROFILE else options.profile)):
        words += [option, str(value)] if value is not None else []
    for service, file in options.config:
        words += ["--config", f"{service}={shown(file)}"]
    return shlex.join(words)


def _backend(options: argparse.Namespace, stack: Stack) -> Backend:
    if options.stacks:
        return Stacks(options.stacks, stack)
    return InProcess(options.jobs or len(os.sched_getaffinity(0)))


def _check_simulates(stack: Stack) -> None:
    """UsageError for a robot: nobody puts it and its object back a hundred times, and it has no seeds."""
    if stack.service("plant") is None:
        raise UsageError(f"--profile {stack.profile}: an experiment's trials are simulated, by the hundred and from "
                         "exact starts, and this profile starts no plant here. Trials on it, one by one: "
                         f"deploy/scarab run --profile {stack.profile}")


def _check_strategies(plans: List[Plan], stack: Stack, places: Places) -> None:
    known = strategies_of(stack, places)
    for plan in plans:
        for strategy in dict.fromkeys(trial.strategy for trial in plan.trials):
            try:
                check_strategy(strategy, known)
            except UsageError as error:
                raise UsageError(f"experiment {plan.experiment.name}: {error}") from None
