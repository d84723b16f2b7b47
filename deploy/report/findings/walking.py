"""Walking straight: no statement of the paper, an aim of Scarab."""

import math

from ..experiment import Experiment
from ..wording import counted, failures
from .finding import Finding, Source, Verdict, graded

BAND_DEG = 10.0


def _keeps_heading(experiment: Experiment, strategy: str, word: str) -> Finding:
    trials = [trial for cell in experiment.of(strategy) for trial in cell.trials]
    statement = f"Walking {word}, the robot stays within {BAND_DEG:g}° of its first heading over 3 m."
    if not trials:
        return Finding(f"walks_{word}", statement, Verdict.OPEN, [], source=Source.AIM)
    turned = [math.degrees(trial.heading_max_rad) for trial in trials]
    inside = [angle <= BAND_DEG and trial.success for angle, trial in zip(turned, trials)]
    cells = experiment.of(strategy)
    numbers = [f"{sum(inside)}/{len(trials)} stay within {BAND_DEG:g}° and arrive",
               f"largest turn: mean {sum(turned) / len(turned):.1f}°, worst {max(turned):.1f}°"]
    numbers += [f"arrive: {counted(cell)}" for cell in cells]
    reason = failures(cells)
    if not all(inside):
        left = sum(trial.heading_rad > 0 for trial in trials)
        reason = "; ".join(filter(None, [
            f"{left} of {len(trials)} turn left in the end, {len(trials) - left} right", reason]))
    return Finding(f"walks_{word}", statement, graded(inside), numbers, reason, Source.AIM)


def forward(experiment: Experiment) -> Finding:
    return _keeps_heading(experiment, "walk-forward", "forward")


def backward(experiment: Experiment) -> Finding:
    return _keeps_heading(experiment, "walk-backward", "backward")


FINDINGS = (forward, backward)
