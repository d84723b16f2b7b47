"""Walking straight: no statement of the paper, an aim of Scarab."""

import math

from ..experiment import Experiment
from ..failure_detail import why_failed
from ..intervals import mean
from ..wording import counted
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
    end = [math.degrees(trial.heading_rad) for trial in trials]
    numbers = [f"{sum(inside)}/{len(trials)} arrive and are within {BAND_DEG:g}° all the way, the sway of steps "
               "included",
               f"largest turn on the way: mean {mean(turned):.1f}°, worst {max(turned):.1f}°",
               f"at the end: mean {mean(end):+.1f}° (+ left), from {min(end):+.1f}° to {max(end):+.1f}°",
               *(f"arrive: {counted(cell)}" for cell in cells)]
    kept = sum(abs(angle) <= BAND_DEG for angle in end)
    reason = "" if all(inside) else "; ".join(filter(None, [
        f"{kept} of {len(trials)} are within {BAND_DEG:g}° at the end", why_failed(cells)]))
    return Finding(f"walks_{word}", statement, graded(inside), numbers, reason, Source.AIM)


def forward(experiment: Experiment) -> Finding:
    return _keeps_heading(experiment, "walk-forward", "forward")


def backward(experiment: Experiment) -> Finding:
    return _keeps_heading(experiment, "walk-backward", "backward")


FINDINGS = (forward, backward)
