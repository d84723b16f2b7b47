"""Signals of the network from the log of a trial (topic scarab/neural_activity)."""

from dataclasses import dataclass
from typing import Dict, List, Optional

from .experiment import Experiment
from .failure import ReportError
from .trial import Conditions

SETTLE_TICKS = 30  # of the change from the row of Table 1 that the network ran in before
PSN_LAYERS = 4  # a signal takes one tick a layer [paper, sections 2 and 2.2]
_PSN = tuple(f"psn{module}[{index}]" for module in (1, 2, 3, 4) for index in (12, 13))
_FIELDS = ("input", "cpg", "vrn1[1]", "vrn1[6]", "vrn2[6]", *_PSN)

# Strategies that hold one row of Table 1 from the start (config/supervisor), with its name there.
TABLE_ROWS = {"table-forward": "forward walking", "table-backward": "backward walking",
              "table-soft-push": "soft pushing", "table-boxing": "boxing-like", "table-hard-push": "hard pushing"}


@dataclass(frozen=True)
class Recording:
    """Columns over ticks."""

    strategy: str
    time_s: List[float]
    columns: Dict[str, List[float]]

    def neuron(self, name: str) -> List[float]:
        """C1, C2, PSN1.P13 and the like, VRN1.V7, VRN2.V7, I1 to I4."""
        if name[0] == "C":
            return self.columns[f"cpg[{int(name[1]) - 1}]"]
        if name[0] == "I":
            return self.columns[f"input[{int(name[1]) - 1}]"]
        module, neuron = name.lower().split(".")
        return self.columns[f"{module}[{int(neuron[1:]) - 1}]"]

    def settled(self, name: str) -> List[float]:
        """Without the first ticks."""
        return self.neuron(name)[SETTLE_TICKS:]

    @property
    def row(self) -> str:
        return TABLE_ROWS.get(self.strategy, self.strategy)


def recording(experiment: Experiment, strategy: str) -> Recording:
    """Of the first trial of the strategy. ReportError where it has no log or is too short."""
    trial = _first(experiment, strategy)
    if trial is None:
        raise ReportError(f"no trial of {strategy} is planned")
    table = experiment.logs.samples(trial, "neural_activity", _FIELDS)
    columns = {name: [float(value) for value in values] for name, values in table.items()}
    time_s = [nanoseconds * 1e-9 for nanoseconds in columns["header.sim_time_ns"]]
    if len(time_s) < 2 * SETTLE_TICKS:
        raise ReportError(f"the log of {strategy} has {len(time_s)} ticks; {2 * SETTLE_TICKS} are needed")
    return Recording(strategy, time_s, columns)


def table_recordings(experiment: Experiment) -> List[Recording]:
    """One for each row of Table 1 that was run."""
    found = [recording(experiment, strategy) for strategy in TABLE_ROWS
             if strategy in experiment.strategies]
    if not found:
        raise ReportError(f"no trial holds a row of Table 1; expected some of {', '.join(TABLE_ROWS)}")
    return found


def _first(experiment: Experiment, strategy: str) -> Optional[Conditions]:
    return next((trial for trial in experiment.plan.trials if trial.strategy == strategy), None)
