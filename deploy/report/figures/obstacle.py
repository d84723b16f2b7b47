"""Fig. 6: success and time across obstacles, by strategy and height."""

from pathlib import Path
from typing import List, Tuple

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from ..cells import Cell
from ..experiment import Experiment
from ..failure import ReportError
from ..intervals import deviation, mean
from ..wording import centimetres
from .style import GREY, INK, PAGE, RULE, journal_style, letter, mode_style, save, sign

_BAR = 0.40
_BASES = ("soft", "boxing", "stationary")


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    """A row of panels for each first mode: alone beside followed by hard pushing."""
    bases = [base for base in _BASES if experiment.of(base) or experiment.of(f"{base}+hard")]
    if not bases:
        raise ReportError("no trial of the six strategies has been run yet")
    heights = experiment.heights_m
    with journal_style():
        figure, axes = plt.subplots(len(bases), 2, sharex=True, sharey="col", squeeze=False,
                                    figsize=(PAGE, 0.5 + 1.85 * len(bases)), layout="constrained")
        for row, (base, (success, time)) in enumerate(zip(bases, axes)):
            for side, strategy in ((-0.5, base), (0.5, f"{base}+hard")):
                _success_bars(success, experiment.of(strategy), heights, side)
                _times(time, experiment.of(strategy), heights, side)
            _dress(success, time, base, "abcdef"[2 * row:2 * row + 2])
        _label_heights(axes, heights)
        axes[0][1].set_ylim(0, axes[0][1].get_ylim()[1])  # once all are drawn: they share it
        count = max(cell.n for cell in experiment.cells)
        sign(figure, experiment.plan.trials, f"{count} trials a bar, with Wilson's 95 % interval; times: mean and "
             "standard deviation, a dash a trial")
        return save(figure, prefix)


def _look(strategy: str) -> Tuple[str, str, str, bool]:
    """Alone is white and hatched, the combination filled: told apart without colour."""
    colour, marker, _ = mode_style(strategy)
    filled = "+" in strategy
    return colour if filled else "white", marker, "" if filled else "////", filled


def _success_bars(axis: Axes, cells: List[Cell], heights: List[float], side: float) -> None:
    for cell in cells:
        face, _, hatch, _ = _look(cell.key.strategy)
        place = heights.index(cell.key.height_m) + side * _BAR
        low, high = (100 * end for end in cell.interval)
        share = 100 * cell.share
        axis.bar(place, share, _BAR * 0.94, color=face, edgecolor=INK, hatch=hatch, linewidth=0.6)
        axis.errorbar(place, share, [[share - low], [high - share]], color=INK, linewidth=0.7, capsize=1.5)
        axis.annotate(cell.count, (place, 104), rotation=90, fontsize=6, ha="center", va="bottom")


def _times(axis: Axes, cells: List[Cell], heights: List[float], side: float) -> None:
    for cell in cells:
        if not cell.times_s:
            continue
        _, marker, _, filled = _look(cell.key.strategy)
        colour, _, _ = mode_style(cell.key.strategy)
        place = heights.index(cell.key.height_m) + side * _BAR
        axis.plot([place] * len(cell.times_s), cell.times_s, linestyle="", marker="_", color=GREY, markersize=4,
                  markeredgewidth=0.5)
        axis.errorbar(place, mean(cell.times_s), deviation(cell.times_s), color=INK, marker=marker, markersize=4.2,
                      markerfacecolor=colour if filled else "white", linewidth=0.8, capsize=1.5, zorder=4)


def _dress(success: Axes, time: Axes, base: str, letters: str) -> None:
    success.set_ylim(0, 134)
    success.set_yticks([0, 25, 50, 75, 100])
    success.set_ylabel("success [%]")
    success.spines["left"].set_bounds(0, 100)
    time.set_ylabel("time of successes [s]")
    for axis in (success, time):
        axis.grid(axis="y", color=RULE, linewidth=0.4)
        axis.set_axisbelow(True)
    letter(success, letters[0])
    letter(time, letters[1])
    both = mode_style(base)[0]
    success.legend(handles=[Patch(facecolor="white", edgecolor=INK, hatch="////", label=f"{base} alone"),
                            Patch(facecolor=both, edgecolor=INK, label=f"{base}, then hard")],
                   loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=2, borderpad=0, borderaxespad=0.2)


def _label_heights(axes, heights: List[float]) -> None:
    for axis in axes[-1]:
        axis.set_xticks(range(len(heights)), [centimetres(height) for height in heights])
        axis.set_xlim(-0.7, len(heights) - 0.3)
        axis.set_xlabel("height of the obstacle [cm]")
