"""The sequence of behaviours (Fig. 7)."""

from typing import List, Optional

from ..behaviour_signals import behaviour_signals
from ..experiment import Experiment
from ..failure_detail import why_failed
from ..failure import ReportError
from ..signal_table import SignalTable
from ..trial import Trial
from ..wording import counted, seconds
from .finding import Finding, Verdict, graded

_PAPER_HEIGHT_M = 0.05
_NAMES = ("climb", "mode 1", "mode 2")


def behaviours_in_order(experiment: Experiment) -> Finding:
    """Of the trials with two modes."""
    trials = [trial for trial in experiment.trials if "+" in trial.asked.strategy]
    met = [_in_order(trial) for trial in trials]
    numbers = [f"{sum(met)}/{len(met)} trials go through all of them, in this order"] if trials else []
    if trials:
        numbers.append("the first trial: " + ", ".join(
            f"{name} " + ("never" if time is None else f"at {seconds(time)}")
            for name, time in zip(_NAMES, trials[0].behaviours_s)))
    statement = "The robot walks backward, climbs the object by itself, then pushes softly and at last hard."
    return Finding("behaviours_in_order", statement, graded(met), numbers, _what_is_missing(trials))


def _what_is_missing(trials: List[Trial]) -> str:
    reasons = []
    for i, name in enumerate(_NAMES):
        without = [trial for trial in trials if trial.behaviours_s[i] is None]
        if without:
            done = sum(trial.success for trial in without)
            reasons.append(f"{len(without)} of {len(trials)} trials never enter {name}" +
                           (f"; {done} of them succeed before" if done else ""))
    return "; ".join(reasons)


def triggers(experiment: Experiment) -> Finding:
    """The two signals at the ticks that they switch at."""
    statement = ("The inclination signal BS starts mode 1 when it is above its threshold for some time; the joint "
                 "signal AS starts mode 2 when it falls below its own.")
    try:
        _, table = behaviour_signals(experiment)
    except ReportError as error:
        return Finding("triggers", statement, Verdict.OPEN, [], str(error))
    met: List[bool] = []
    numbers: List[str] = []
    for state, signal, above in (("MODE_1", "bs", True), ("MODE_2", "as", False)):
        at = _entered(table.state, state)
        if at is None:
            met.append(False)
            numbers.append(_nearest(table, state, signal, above))
            continue
        value, threshold = table.signals[f"{signal}_rad"][at], table.signals[f"{signal}_threshold_rad"][at]
        met.append(value > threshold if above else value < threshold)
        numbers.append(f"{signal.upper()} is {value:.3f} rad when {state.replace('_', ' ').lower()} starts at "
                       f"{table.time_s[at]:.1f} s; the threshold is {threshold:.3f} rad")
    return Finding("triggers", statement, graded(met), numbers)


def _nearest(table: SignalTable, state: str, signal: str, above: bool) -> str:
    """Of a behaviour that was never entered: how near the signal came to its threshold, after mode 1 began."""
    name = state.replace("_", " ").lower()
    start = _entered(table.state, "MODE_1") or 0
    margins = [(value - threshold if above else threshold - value, value) for value, threshold in
               zip(table.signals[f"{signal}_rad"][start:], table.signals[f"{signal}_threshold_rad"][start:])]
    value = max(margins)[1]
    threshold = table.signals[f"{signal}_threshold_rad"][-1]
    return f"{name} was never entered: {signal.upper()} came to {value:.3f} rad, the threshold is {threshold:.3f} rad"


def crosses(experiment: Experiment) -> Finding:
    cells = [cell for cell in experiment.cells if cell.key.height_m == _PAPER_HEIGHT_M and cell.n]
    return Finding("crosses", "The object is moved across an obstacle of 5 cm.",
                   graded([trial.success for cell in cells for trial in cell.trials]),
                   [f"{cell.key.strategy}: {counted(cell)}" for cell in cells], why_failed(cells))


def _in_order(trial: Trial) -> bool:
    climb, mode1, mode2 = trial.behaviours_s
    return None not in (climb, mode1, mode2) and climb <= mode1 < mode2 <= trial.time_s


def _entered(states: List[str], state: str) -> Optional[int]:
    return states.index(state) if state in states else None


FINDINGS = (behaviours_in_order, triggers, crosses)
