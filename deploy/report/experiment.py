"""An experiment's directory, read."""

from pathlib import Path
from typing import Dict, List, Optional

from .cells import Cell
from .failure import ReportError
from .logs import Logs
from .plan import Plan, read_plan
from .results import read_results
from .trial import CellKey, Conditions, Trial


class Experiment:
    """What was asked for, what came out, and the logs of it."""

    def __init__(self, plan: Plan, trials: List[Trial], logs: Logs):
        self.plan = plan
        self.trials = trials
        self.logs = logs
        self.cells = _cells(plan.trials, trials)

    @property
    def strategies(self) -> List[str]:
        """In the order of the plan."""
        return list(dict.fromkeys(trial.strategy for trial in self.plan.trials))

    @property
    def heights_m(self) -> List[float]:
        return sorted({trial.height_m for trial in self.plan.trials})

    @property
    def is_complete(self) -> bool:
        return len(self.trials) == len(self.plan.trials)

    def of(self, strategy: str) -> List[Cell]:
        """Cells of a strategy by height; those without a trial yet are left out."""
        return sorted((cell for cell in self.cells if cell.key.strategy == strategy and cell.n),
                      key=lambda cell: cell.key.height_m)

    def at(self, strategy: str, height_m: float) -> Optional[Cell]:
        return next((cell for cell in self.of(strategy) if cell.key.height_m == height_m), None)


def read_experiment(directory: Path, bin: Path) -> Experiment:
    """ReportError with the reason where plan.json or results.csv do not serve."""
    plan = read_plan(directory / "plan.json")
    trials = read_results(directory / "results.csv")
    asked = {trial.index: trial for trial in plan.trials}
    for trial in trials:
        if asked.get(trial.asked.index) != trial.asked:
            raise ReportError(f"{directory / 'results.csv'}: the trial with index {trial.asked.index} "
                              "is not the one of plan.json")
        if trial.configuration != plan.configuration:
            raise ReportError(f"{directory / 'results.csv'}: index {trial.asked.index} was run with "
                              f"configuration {trial.configuration}, plan.json says {plan.configuration}")
    return Experiment(plan, trials, Logs(directory, bin))


def _cells(planned: List[Conditions], trials: List[Trial]) -> List[Cell]:
    """In the order of the plan. A trial that stands in two grids of it is one trial, run twice."""
    seeds: Dict[CellKey, List[int]] = {}
    for trial in planned:
        seeds.setdefault(trial.cell, []).append(trial.seed)
    run: Dict[CellKey, Dict[int, Trial]] = {key: {} for key in seeds}
    for trial in trials:
        run[trial.asked.cell].setdefault(trial.asked.seed, trial)
    return [Cell(key, len(set(found)), list(run[key].values())) for key, found in seeds.items()]
