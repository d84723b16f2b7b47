"""`scarab experiment`: named experiments, run, resumed, divided over machines and put together again."""

import argparse
import re
from pathlib import Path
from typing import List

from .experiments.dry_run import plan_text
from .experiments.experiment_file import (EXPERIMENT_WORDS, Experiment, find_experiment,
                                          known_experiments, read_experiment)
from .experiments.plan import Shard, make_plan
from .failure import EXIT_OK, UsageError
from .places import Places
from .stack_options import DEFAULT_PROFILE, add_data_options, add_profile_option, bounded_integer
from .strict_yaml import did_you_mean
from .verbs import Verbs

_MOST_AT_A_TIME = 64
_MORE = """NAME is one of `deploy/scarab experiment list`, or a file such as config/experiments/obstacle.yaml.
Trials are run in process, on all cores, unless --stacks says otherwise; both give the same results,
byte for byte. Interrupted, the same command goes on where it was; finished, it draws the report anew.

  list        the experiments, with their figures and the number of their trials
  all         every one of them in turn, and a page that links them
  merge DIR.. the shards of an experiment become one directory, as if it had been run at once

A trial that fails is a result: the exit code is 0 once every trial has been run."""
_EXAMPLES = """deploy/scarab experiment obstacle
deploy/scarab experiment obstacle --stacks 2
deploy/scarab experiment transport_speed --trials 3 --out /tmp/quick
deploy/scarab experiment beyond --shard 2/8 --out shard-2
deploy/scarab experiment merge shard-* --out runs/experiments/beyond"""


def add_verb(verbs: Verbs) -> None:
    parser = verbs.add("experiment", experiment, "run the experiments of the paper, and those beyond it",
                       _EXAMPLES, _MORE, operands=" NAME", of_stack=False)
    parser.add_argument("experiment", metavar="NAME", help="of an experiment; or list, all, merge")
    parser.add_argument("directories", nargs="*", metavar="DIR",
                        help="of merge: the directories of the shards")
    who = parser.add_argument_group("who runs the trials").add_mutually_exclusive_group()
    who.add_argument("--inproc", action="store_true",
                     help="processes with the cores of all services, one on each core (this is the default)")
    who.add_argument("--stacks", type=bounded_integer(1, _MOST_AT_A_TIME), metavar="K",
                     help="K stacks of processes side by side, each on a DDS domain of its own")
    parser.add_argument("--jobs", type=bounded_integer(1, _MOST_AT_A_TIME), metavar="J",
                        help="of --inproc: how many processes (as many as there are cores)")
    parser.add_argument("--trials", type=bounded_integer(1, 100000), metavar="N",
                        help="in each cell (the experiment's own number)")
    parser.add_argument("--seed", type=bounded_integer(0, 2**64 - 1), metavar="S",
                        help="of each cell's first trial (the experiment's own)")
    parser.add_argument("--out", type=Path, metavar="DIR",
                        help="where results go (runs/experiments/NAME; with --shard NAME-shard-I-of-N)")
    parser.add_argument("--shard", type=_shard, metavar="I/N", default=Shard(),
                        help="every N-th trial only, from the I-th on: for one of N machines")
    parser.add_argument("--fresh", action="store_true",
                        help="start over: what lies in the directory is removed")
    parser.add_argument("--no-report", dest="report", action="store_false",
                        help="leave figures and report to deploy/report/report.py DIR, later")
    parser.add_argument("--dry-run", action="store_true", help="show what would be run")
    add_profile_option(parser)
    add_data_options(parser)


def experiment(options: argparse.Namespace, places: Places) -> int:
    """Failure where trials cannot be run."""
    _check_together(options)
    if options.experiment == "list":
        print(list_text(places.root))
        return EXIT_OK
    # Here, or every start of the launcher, each completion among them, would wait for these.
    from .experiment_run import merge_shards, run_plans
    if options.experiment == "merge":
        return merge_shards(options, places)
    if options.experiment == "all":
        files = [find_experiment(e.name, places.root) for e in _in_order(places.root)]
    else:
        files = [_file(options.experiment, places.root)]
    plans = [make_plan(read_experiment(file), options.trials, options.seed) for file in files]
    if options.dry_run:
        print("\n\n".join(plan_text(plan, options.shard) for plan in plans))
        return EXIT_OK
    return run_plans(plans, options, places)


def list_text(root: Path) -> str:
    """A line for each experiment."""
    rows = [("NAME", "FIGURE", "TRIALS", "")]
    for each in _in_order(root):
        rows.append((each.name, each.paper_figure or "-", str(len(make_plan(each).trials)), each.title))
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    return "\n".join(f"{name:{widths[0]}}  {figure:{widths[1]}}  {trials:>{widths[2]}}  {title}".rstrip()
                     for name, figure, trials, title in rows)


def _in_order(root: Path) -> List[Experiment]:
    """By their figures; those without one behind, the smallest first."""
    found = [read_experiment(find_experiment(name, root)) for name in known_experiments(root)]
    return sorted(found, key=lambda e: (not e.paper_figure, e.paper_figure,
                                        len(make_plan(e).trials), e.name))


def _file(word: str, root: Path) -> Path:
    near = did_you_mean(word, EXPERIMENT_WORDS)
    if near and not did_you_mean(word, known_experiments(root)):
        raise UsageError(f"unknown experiment '{word}'{near}")
    return find_experiment(word, root)


def _check_together(options: argparse.Namespace) -> None:
    """UsageError for options that contradict each other, or what is to be done."""
    if options.jobs and options.stacks:
        raise UsageError("--jobs is of --inproc; --stacks says itself how many")
    if options.experiment == "merge":
        if not options.directories:
            raise UsageError("experiment merge needs the directories of the shards")
        of_a_run = {"--trials": options.trials, "--seed": options.seed, "--stacks": options.stacks,
                    "--inproc": options.inproc, "--jobs": options.jobs, "--dry-run": options.dry_run,
                    "--shard": not options.shard.whole, "--robot": options.robot, "--config": options.config,
                    "--profile": options.profile != DEFAULT_PROFILE}
        for option, given in of_a_run.items():
            if given:
                raise UsageError(f"{option} is not for merge: the shards say how they were run")
    elif options.directories:
        raise UsageError(f"unknown argument '{options.directories[0]}': only merge takes directories")


def _shard(text: str) -> Shard:
    match = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", text)
    if match is None:
        raise argparse.ArgumentTypeError(f"'{text}' is not I/N, such as 2/8")
    shard = Shard(int(match[1]), int(match[2]))
    if not 1 <= shard.number <= shard.of:
        raise argparse.ArgumentTypeError(f"there is no shard {shard.number} of {shard.of}: they count from 1 to "
                                         f"{shard.of}")
    return shard
