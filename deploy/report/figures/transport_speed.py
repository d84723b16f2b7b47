"""Fig. 5: time to push the object over the flat, by mode."""

import textwrap
from pathlib import Path
from typing import Dict, List

import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from ..cells import Cell
from ..experiment import Experiment
from ..failure import ReportError
from ..findings.finding import does_the_job
from ..intervals import deviation, mean
from .spread_out import spread_out
from .style import COLUMN, GREY, INK, RULE, journal_style, mode_style, save, sign

_BAR = 0.62
_LABEL_COLUMNS = 14  # of a mode's failures, in letters


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    cells = [cell for strategy in experiment.strategies for cell in experiment.of(strategy)]
    if not cells:
        raise ReportError("no trial has been run yet")
    with journal_style():
        figure, (failed, axis) = plt.subplots(2, 1, sharex=True, figsize=(COLUMN, 3.6), layout="constrained",
                                              gridspec_kw={"height_ratios": [0.25, 1.0]})
        for place, cell in enumerate(cells):
            _arrivals(axis, place, cell)
        lines = max(_failures(failed, place, cell) for place, cell in enumerate(cells))
        _dress(failed, axis, cells, lines)
        barless = [] if all(map(does_the_job, cells)) else ["no bar where fewer than half arrive"]
        sign(figure, experiment.plan.trials, f"{_counts(cells)} trials a mode", *barless)
        return save(figure, prefix)


def _arrivals(axis: Axes, place: int, cell: Cell) -> None:
    colour, marker, hatch = mode_style(cell.key.strategy)
    times = cell.times_s
    if not times:
        axis.text(place, 0.5, "none arrived", transform=axis.get_xaxis_transform(), rotation=90,
                  ha="center", va="center", color=GREY)
        return
    if does_the_job(cell):
        axis.bar(place, mean(times), _BAR, color=colour, edgecolor=INK, hatch=hatch, linewidth=0.6, alpha=0.55)
        axis.errorbar(place, mean(times), deviation(times), color=INK, capsize=4, linewidth=1.0, zorder=4)
    axis.plot([place + shift for shift in spread_out(len(times), _BAR * 0.32)], times, linestyle="", marker=marker,
              markersize=3.2, markerfacecolor="white", markeredgecolor=INK, markeredgewidth=0.6, zorder=5)
    top = max([*times, mean(times) + (deviation(times) or 0)])
    axis.annotate(cell.count, (place, top), xytext=(0, 4), textcoords="offset points", ha="center", va="bottom")


def _failures(axis: Axes, place: int, cell: Cell) -> int:
    """A cross each, and how many lines of words above them say why."""
    count = cell.n - cell.successes
    shifts = spread_out(count, _BAR * 0.5 * min(1.0, (count - 1) / 9))
    axis.plot([place + shift for shift in shifts], [0.0] * count, linestyle="", marker="x", color=INK,
              markersize=3.5, markeredgewidth=0.8)
    words = [f"{times} × {kind.replace('object ', '').replace('robot ', '')}" for kind, times in cell.failures.items()]
    lines = [line for word in words for line in textwrap.wrap(word, _LABEL_COLUMNS)]
    axis.annotate("\n".join(lines), (place, 0), xytext=(0, 5), fontsize=6, linespacing=1.05,
                  textcoords="offset points", ha="center", va="bottom", color=GREY)
    return len(lines)


def _dress(failed: Axes, axis: Axes, cells: List[Cell], lines: int) -> None:
    failed.set_ylim(-0.6, 1.0 + 0.9 * lines)
    failed.spines["left"].set_visible(False)
    if lines == 0:
        failed.annotate("none", (0.0, 0.0), xytext=(2, 0), xycoords=("axes fraction", "data"), va="center",
                        textcoords="offset points", color=GREY)
    failed.set_yticks([0], ["failed"])
    failed.tick_params(axis="both", length=0)
    failed.spines["bottom"].set_color(RULE)
    axis.set_xticks(range(len(cells)), [cell.key.strategy for cell in cells])
    axis.set_xlim(-0.6, len(cells) - 0.4)
    axis.set_ylim(0, axis.get_ylim()[1] * 1.08)
    axis.tick_params(axis="x", length=0)
    distance = cells[0].trials[0].asked.distance_m
    axis.set_ylabel(f"time to move the object {distance:g} m [s]\n(mean, standard deviation)")


def _counts(cells: List[Cell]) -> str:
    numbers: Dict[int, None] = dict.fromkeys(cell.n for cell in cells)
    return " or ".join(map(str, numbers))
