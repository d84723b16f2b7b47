"""Further than the paper: success and time of soft+hard by height, against the aims."""

from pathlib import Path
from typing import List

import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from ..cells import Cell
from ..experiment import Experiment
from ..failure import ReportError
from ..findings.beyond import STRATEGY, aim_at
from ..intervals import deviation, mean
from ..wording import centimetres
from .spread_out import spread_out
from .style import BLUE, GREY, INK, PAGE, RULE, VERMILION, journal_style, letter, save, sign


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    cells = experiment.of(STRATEGY)
    if not cells:
        raise ReportError(f"no trial of {STRATEGY} has been run yet")
    with journal_style():
        figure, (success, time) = plt.subplots(2, 1, sharex=True, figsize=(PAGE, 4.2), layout="constrained",
                                               gridspec_kw={"height_ratios": [1.15, 1.0]})
        for place, cell in enumerate(cells):
            _success(success, place, cell)
            _time(time, place, cell)
        _dress(success, time, cells)
        count = max(cell.n for cell in cells)
        sign(figure, experiment.plan.trials, f"{STRATEGY}, one parameter set, {count} trials a height")
        return save(figure, prefix)


def _success(axis: Axes, place: int, cell: Cell) -> None:
    share = 100 * cell.share
    low, high = (100 * end for end in cell.interval)
    axis.bar(place, share, 0.6, color=BLUE, alpha=0.55, edgecolor=INK, linewidth=0.6)
    axis.errorbar(place, share, [[share - low], [high - share]], color=INK, capsize=3, linewidth=0.9)
    axis.annotate(cell.count, (place, 104), ha="center", va="bottom")
    aim = aim_at(cell.key.height_m)
    if aim is not None:
        axis.plot([place - 0.42, place + 0.42], [100 * aim] * 2, color=VERMILION, linestyle=(0, (3, 1)), linewidth=1.5)


def _time(axis: Axes, place: int, cell: Cell) -> None:
    times = cell.times_s
    if not times:
        return
    axis.plot([place + shift for shift in spread_out(len(times), 0.28)], times, linestyle="", marker=".",
              markersize=2.5, color=GREY)
    axis.errorbar(place, mean(times), deviation(times), color=INK, marker="o", markerfacecolor="white", markersize=4.5,
                  capsize=3, linewidth=0.9, zorder=4)


def _dress(success: Axes, time: Axes, cells: List[Cell]) -> None:
    success.set_ylim(0, 116)
    success.set_yticks([0, 25, 50, 75, 100])
    success.spines["left"].set_bounds(0, 100)
    success.set_ylabel("success [%]\n(Wilson's 95 % interval)")
    success.plot([], [], color=VERMILION, linestyle=(0, (3, 1)), linewidth=1.5, label="aim")
    success.legend(loc="lower right", bbox_to_anchor=(1, 1.0), borderaxespad=0)
    time.set_ylim(0, None)
    time.set_ylabel("time of successes [s]\n(mean, standard deviation)")
    for axis in (success, time):
        axis.grid(axis="y", color=RULE, linewidth=0.4)
        axis.set_axisbelow(True)
    letter(success, "a")
    letter(time, "b")
    names = [centimetres(cell.key.height_m) if cell.key.height_m else "flat" for cell in cells]
    time.set_xticks(range(len(cells)), names)
    time.set_xlim(-0.6, len(cells) - 0.4)
    time.set_xlabel("height of the obstacle [cm]")
