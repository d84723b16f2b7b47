"""The signals of Fig. 7 from the log of an experiment's trial."""

from typing import Dict, List, Tuple

from .experiment import Experiment
from .failure import ReportError
from .signal_table import JOINT_SLOTS, SignalTable, joined
from .trial import Conditions

_BEHAVIOUR = ("state", "mode", "bs_rad", "bs_threshold_rad", "as_rad", "as_threshold_rad")


def behaviour_signals(experiment: Experiment) -> Tuple[Conditions, SignalTable]:
    """Of the first trial that has a log, one that went through all behaviours and succeeded before others.

    ReportError where none has.
    """
    trial = _shown_trial(experiment)
    behaviour = experiment.logs.samples(trial, "behaviour", _BEHAVIOUR)
    positions = tuple(f"position_rad[{slot}]" for slot in JOINT_SLOTS.values())
    robot_state = experiment.logs.samples(trial, "robot_state", positions)
    return trial, joined(_rows(behaviour), _rows(robot_state), "scarab/behaviour and scarab/robot_state of the log")


def _shown_trial(experiment: Experiment) -> Conditions:
    run = sorted(experiment.trials, key=lambda trial: (not trial.success, None in trial.behaviours_s,
                                                       trial.asked.index))
    for trial in run:
        if experiment.logs.has(trial.asked):
            return trial.asked
    raise ReportError("no trial that has been run has a log")


def _rows(table: Dict[str, List[str]]) -> List[Dict[str, str]]:
    return [dict(zip(table, values)) for values in zip(*table.values())]
