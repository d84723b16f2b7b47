"""Walking straight: the trunk's way from above, and its heading."""

import math
from pathlib import Path
from typing import Dict, List, Tuple

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..experiment import Experiment
from ..failure import ReportError
from ..findings.walking import BAND_DEG
from ..walk import Walk, read_walk
from .spread_out import spread_out
from .style import COLUMN, GREY, INK, PAGE, RULE, journal_style, letter, mode_style, save, sign

_LINES = ("-", (0, (4, 1.5)))
_THINNED = 5  # every fifth sample is drawn: 10 a second


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    """Without logs only how far each trial turned."""
    strategies = [strategy for strategy in experiment.strategies if experiment.of(strategy)]
    if not strategies:
        raise ReportError("no trial has been run yet")
    walks = {strategy: [read_walk(experiment, trial.asked) for cell in experiment.of(strategy)
                        for trial in cell.trials if experiment.logs.has(trial.asked)] for strategy in strategies}
    with journal_style():
        if any(walks.values()):
            figure, turn = _with_ways(walks)
        else:
            figure, turn = plt.subplots(figsize=(COLUMN, 2.9), layout="constrained")
        _largest_turn(turn, experiment, strategies)
        count = max(cell.n for cell in experiment.cells)
        sign(figure, experiment.plan.trials, f"{count} trials a direction")
        return save(figure, prefix)


def _with_ways(walks: Dict[str, List[Walk]]) -> Tuple[Figure, Axes]:
    """Draws all but the last panel, and gives its axes."""
    figure = plt.figure(figsize=(PAGE, 4.6), layout="constrained")
    grid = figure.add_gridspec(2, len(walks) + 1, height_ratios=[1.0, 1.3], width_ratios=[1.3] * len(walks) + [1.0])
    above = figure.add_subplot(grid[0, :])
    _from_above(above, walks)
    letter(above, "a", "ways of the trunk from above; grey: a straight way within 10° of the first heading")
    first = None
    for column, (strategy, found) in enumerate(walks.items()):
        first = axis = figure.add_subplot(grid[1, column], sharey=first)
        _heading(axis, strategy, found)
        letter(axis, "bcd"[column], f"{strategy.replace('walk-', '')}: heading")
        axis.tick_params(labelleft=column == 0)
        if column == 0:
            axis.set_ylabel("heading against the first [°]")
    turn = figure.add_subplot(grid[1, -1])
    letter(turn, "bcd"[len(walks)], "largest turn")
    return figure, turn


def _from_above(axis: Axes, walks: Dict[str, List[Walk]]) -> None:
    for (strategy, found), line in zip(walks.items(), _LINES):
        for i, walk in enumerate(found):
            axis.plot(walk.x_m[::_THINNED], walk.y_m[::_THINNED], color=mode_style(strategy)[0], linestyle=line,
                      linewidth=0.7, label=strategy.replace("walk-", "") if i == 0 else None)
    _cone(axis, max(max(walk.distance_m) for found in walks.values() for walk in found))
    axis.plot(0, 0, marker="o", markersize=3, color=INK)
    axis.set_xlabel("along the first heading [m]")
    axis.set_ylabel("to the left [m]")
    axis.set_aspect("equal", adjustable="datalim")
    axis.legend(loc="lower left", ncol=2)


def _cone(axis: Axes, reach_m: float) -> None:
    """Where a straight way within the band would go, for- and backward."""
    side = reach_m * math.tan(math.radians(BAND_DEG))
    for x in (-reach_m, reach_m):
        axis.fill([0, x, x], [0, side, -side], color="#ececec", linewidth=0, zorder=-1)


def _heading(axis: Axes, strategy: str, found: List[Walk]) -> None:
    axis.axhspan(-BAND_DEG, BAND_DEG, color="#ececec", linewidth=0, zorder=-1)
    for walk in found:
        axis.plot(walk.distance_m[::_THINNED], [math.degrees(angle) for angle in walk.heading_rad[::_THINNED]],
                  color=mode_style(strategy)[0], linewidth=0.5, alpha=0.7)
    axis.axhline(0, color=RULE, linewidth=0.5, zorder=0)
    axis.set_xlabel("distance from the start [m]")


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
    axis.set_ylim(0, max([BAND_DEG, *axis.get_ylim()]) * 1.18)
    axis.set_ylabel("largest turn in a trial [°]")
    axis.annotate(f"within {BAND_DEG:g}°", (0.5, 0), xycoords=("axes fraction", "data"), xytext=(0, 2),
                  textcoords="offset points", ha="center", va="bottom", fontsize=6.5, color=GREY)
