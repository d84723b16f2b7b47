"""Walking straight: the trunk's way from above, and its heading."""

import math
from pathlib import Path
from typing import Dict, List

import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from ..experiment import Experiment
from ..failure import ReportError
from ..findings.walking import BAND_DEG
from ..walk import Walk, read_walk
from .spread_out import spread_out
from .style import GREY, INK, PAGE, RULE, journal_style, letter, mode_style, save, sign

_LINES = ("-", (0, (4, 1.5)))


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    """Without logs only how far each trial turned."""
    strategies = [strategy for strategy in experiment.strategies if experiment.of(strategy)]
    if not strategies:
        raise ReportError("no trial has been run yet")
    walks = {strategy: [read_walk(experiment, trial.asked) for cell in experiment.of(strategy)
                        for trial in cell.trials if experiment.logs.has(trial.asked)] for strategy in strategies}
    with journal_style():
        if any(walks.values()):
            figure, axes = plt.subplots(1, 3, figsize=(PAGE, 2.9), layout="constrained",
                                        gridspec_kw={"width_ratios": [1.35, 1.35, 0.8]})
            _from_above(axes[0], walks)
            _heading(axes[1], walks)
            letter(axes[0], "a", "from above")
            letter(axes[1], "b", "heading on the way")
            letter(axes[2], "c", "largest turn")
        else:
            figure, axis = plt.subplots(figsize=(PAGE / 2, 2.9), layout="constrained")
            axes = [axis]
        _largest_turn(axes[-1], experiment, strategies)
        count = max(cell.n for cell in experiment.cells)
        sign(figure, experiment.plan.trials, f"{count} trials a direction")
        return save(figure, prefix)


def _from_above(axis: Axes, walks: Dict[str, List[Walk]]) -> None:
    reach = max(max(walk.distance_m) for found in walks.values() for walk in found)
    for (strategy, found), line in zip(walks.items(), _LINES):
        for i, walk in enumerate(found):
            axis.plot(walk.x_m, walk.y_m, color=mode_style(strategy)[0], linestyle=line, linewidth=0.7,
                      label=strategy.replace("walk-", "") if i == 0 else None)
    _cone(axis, reach)
    axis.plot(0, 0, marker="o", markersize=3, color=INK)
    axis.set_xlabel("along the first heading [m]")
    axis.set_ylabel("to the left [m]")
    axis.set_aspect("equal", adjustable="datalim")
    axis.legend(loc="upper center", ncol=2)


def _cone(axis: Axes, reach_m: float) -> None:
    """Where a straight way within the band would go, for- and backward."""
    side = reach_m * math.tan(math.radians(BAND_DEG))
    for x in (-reach_m, reach_m):
        axis.fill([0, x, x], [0, side, -side], color="#ececec", linewidth=0, zorder=-1)


def _heading(axis: Axes, walks: Dict[str, List[Walk]]) -> None:
    axis.axhspan(-BAND_DEG, BAND_DEG, color="#ececec", linewidth=0, zorder=-1)
    for (strategy, found), line in zip(walks.items(), _LINES):
        for walk in found:
            axis.plot(walk.distance_m, [math.degrees(angle) for angle in walk.heading_rad],
                      color=mode_style(strategy)[0], linestyle=line, linewidth=0.7)
    axis.axhline(0, color=RULE, linewidth=0.5, zorder=0)
    axis.set_xlabel("distance from the start [m]")
    axis.set_ylabel("heading against the first [°]")


def _largest_turn(axis: Axes, experiment: Experiment, strategies: List[str]) -> None:
    axis.axhspan(0, BAND_DEG, color="#ececec", linewidth=0, zorder=-1)
    for place, strategy in enumerate(strategies):
        trials = [trial for cell in experiment.of(strategy) for trial in cell.trials]
        turned = [math.degrees(trial.heading_max_rad) for trial in trials]
        colour, marker, _ = mode_style(strategy)
        shifts = spread_out(len(turned), 0.25)
        axis.plot([place + shift for shift in shifts], turned, linestyle="", marker=marker, markersize=3.4,
                  markerfacecolor=colour, markeredgecolor=INK, markeredgewidth=0.5)
        inside = sum(trial.success and angle <= BAND_DEG for trial, angle in zip(trials, turned))
        axis.annotate(f"{inside}/{len(trials)}", (place, 1), xycoords=("data", "axes fraction"), ha="center",
                      va="top")
    axis.set_xticks(range(len(strategies)), [strategy.replace("walk-", "") for strategy in strategies])
    axis.set_xlim(-0.5, len(strategies) - 0.5)
    axis.set_ylim(0, max(axis.get_ylim()[1], BAND_DEG) * 1.18)
    axis.set_ylabel("largest turn in a trial [°]")
    axis.annotate(f"within {BAND_DEG:g}°", (0.5, BAND_DEG), xycoords=("axes fraction", "data"), xytext=(0, -2),
                  textcoords="offset points", ha="center", va="top", fontsize=6.5, color=GREY)
