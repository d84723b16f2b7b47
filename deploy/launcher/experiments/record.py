"""plan.json: what was asked for, with which files, and every session that worked at it."""

import time
from dataclasses import asdict, dataclass, field
from typing import Dict, List, Optional

from ..failure import Failure
from ..places import shown
from ..process_identity import read_json, write_json
from .directory import ExperimentDirectory
from .plan import Plan, PlannedTrial, Shard


@dataclass
class Session:
    """One call of the launcher that ran trials."""

    command: str
    version: str
    backend: str
    started: str = field(default_factory=lambda: time.strftime("%Y-%m-%d %H:%M:%S %z"))
    trials: int = 0       # that it ran
    wall_s: float = 0.0
    simulated_s: float = 0.0


@dataclass
class Record:
    """The file's content."""

    name: str
    title: str
    figure: str
    paper_figure: str
    paper: List[str]
    notes: List[str]
    command: str
    version: str
    configuration: str
    robot: str
    recorded: bool
    shard: str  # such as 2/8; empty: the whole plan
    trials_per_cell: int
    first_seed: int
    sessions: List[Session]
    trials: List[PlannedTrial]  # of the whole plan

    def write(self, directory: ExperimentDirectory) -> None:
        write_json(directory.plan, asdict(self))

    def the_shard(self) -> Shard:
        number, _, of = (self.shard or "1/1").partition("/")
        return Shard(int(number), int(of))

    def own_trials(self) -> List[PlannedTrial]:
        shard = self.the_shard()
        return [trial for trial in self.trials if shard.has(trial)]

    def difference_to(self, wanted: "Record") -> Optional[str]:
        """What of the plan is another one, in words; None where `wanted` goes on with this."""
        for name, words in (("name", "experiment"), ("robot", "robot"), ("shard", "shard"),
                            ("trials_per_cell", "trials in a cell"), ("first_seed", "first seed"),
                            ("recorded", "recording")):
            mine, other = getattr(self, name), getattr(wanted, name)
            if mine != other:
                return f"{words} {_said(mine)}, not {_said(other)}"
        return _difference_of_trials(self.trials, wanted.trials)


def make_record(plan: Plan, shard: Shard, robot: str, configuration: str, command: str,
                version: str) -> Record:
    """Of nothing run as yet."""
    experiment = plan.experiment
    return Record(
        name=experiment.name, title=experiment.title, figure=experiment.figure,
        paper_figure=experiment.paper_figure, paper=list(experiment.paper), notes=list(experiment.notes),
        command=command, version=version, configuration=configuration, robot=robot,
        recorded=experiment.record, shard="" if shard.whole else str(shard),
        trials_per_cell=plan.trials_per_cell, first_seed=plan.first_seed, sessions=[], trials=plan.trials)


def read_record(directory: ExperimentDirectory) -> Optional[Record]:
    """None where nothing has been planned there. Failure for a file that this program has not written."""
    if not directory.plan.exists():
        return None
    value = read_json(directory.plan)
    try:
        return _record(value)
    except (KeyError, TypeError, ValueError):
        raise Failure(f"{shown(directory.plan)} is not a plan of this version of Scarab: start over with "
                      "--fresh, or choose another directory with --out") from None


def _record(value: Optional[dict]) -> Record:
    known: Dict[str, object] = dict(value or {})
    known["sessions"] = [Session(**session) for session in known["sessions"]]
    known["trials"] = [PlannedTrial(**trial) for trial in known["trials"]]
    return Record(**known)


def _difference_of_trials(mine: List[PlannedTrial], others: List[PlannedTrial]) -> Optional[str]:
    for trial, other in zip(mine, others):
        key = trial.differs_from(other)
        if key is not None:
            was, is_now = getattr(trial, key), getattr(other, key)
            return f"trial {trial.index} with {key} {_said(was)}, not {_said(is_now)}"
    if len(mine) != len(others):
        return f"{len(mine)} trials, not {len(others)}"
    return None


def _said(value: object) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, float):
        return f"{value:g}"
    return str(value) or "none"
