"""The trials of an experiment, in order."""

import itertools
import json
from dataclasses import asdict, dataclass, fields, replace
from typing import Dict, Iterator, List, Optional, Tuple

from ..failure import UsageError
from .declaration import MOST_SEED
from .experiment_file import Experiment, Grid


@dataclass(frozen=True)
class PlannedTrial:
    """A line of the worker protocol; its keys, and their order, are these."""

    index: int
    strategy: str
    goal: str
    height_m: float
    distance_m: float
    time_limit_s: float
    seed: int
    perturb_position_m: float
    perturb_yaw_rad: float
    perturb_friction: float
    perturb_cpg_phase: bool
    friction_scale: float
    object_mass_kg: float
    object_diameter_m: float

    def line(self) -> str:
        return json.dumps(asdict(self))

    def cell(self) -> "PlannedTrial":
        """The same for all trials that differ in their seed alone."""
        return replace(self, index=0, seed=0)

    def differs_from(self, other: "PlannedTrial") -> Optional[str]:
        """The first key with another value."""
        return next((key for key in TRIAL_KEYS if getattr(self, key) != getattr(other, key)), None)


TRIAL_KEYS = tuple(field.name for field in fields(PlannedTrial))


@dataclass(frozen=True)
class Shard:
    """Part `number` (from 1) of `of`: the trials whose index leaves the remainder number - 1."""

    number: int = 1
    of: int = 1

    @property
    def whole(self) -> bool:
        return self.of == 1

    def __str__(self) -> str:
        return f"{self.number}/{self.of}"

    def has(self, trial: PlannedTrial) -> bool:
        return trial.index % self.of == self.number - 1


@dataclass(frozen=True)
class Section:
    """The trials of one grid, and what varies in it."""

    varied: Tuple[str, ...]
    trials: Tuple[PlannedTrial, ...]


@dataclass(frozen=True)
class Plan:
    """Of the whole experiment. Trial `index` is number index % trials_per_cell of its cell."""

    experiment: Experiment
    trials_per_cell: int
    first_seed: int
    sections: Tuple[Section, ...]

    @property
    def trials(self) -> List[PlannedTrial]:
        return [trial for section in self.sections for trial in section.trials]

    def of_shard(self, shard: Shard) -> List[PlannedTrial]:
        return [trial for trial in self.trials if shard.has(trial)]


def make_plan(experiment: Experiment, trials_per_cell: Optional[int] = None,
              first_seed: Optional[int] = None) -> Plan:
    """With other numbers than the file's where they are given. UsageError for seeds that do not exist."""
    count = trials_per_cell or experiment.trials
    seed = experiment.first_seed if first_seed is None else first_seed
    if seed + count - 1 > MOST_SEED:
        raise UsageError(f"--seed {seed}: {count} trials need seeds above {MOST_SEED}")
    sections: List[Section] = []
    index = 0
    for grid in experiment.grids:
        trials = []
        for scene, number in itertools.product(_cells(grid, experiment), range(count)):
            trials.append(_trial(index, scene, seed + number, experiment))
            index += 1
        varied = tuple(name for name, values in grid.lists.items() if len(values) > 1)
        sections.append(Section(varied, tuple(trials)))
    return Plan(experiment, count, seed, tuple(sections))


def _cells(grid: Grid, experiment: Experiment) -> Iterator[Dict[str, object]]:
    for values in itertools.product(*grid.lists.values()):
        yield {**experiment.every_trial, **dict(zip(grid.lists, values))}


def _trial(index: int, scene: Dict[str, object], seed: int, experiment: Experiment) -> PlannedTrial:
    perturbation = {f"perturb_{key}": value for key, value in asdict(experiment.perturbation).items()}
    return PlannedTrial(index=index, seed=seed, **scene, **perturbation)
