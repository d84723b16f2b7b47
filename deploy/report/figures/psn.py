"""Fig. 3 b, c: what the phase switching networks get and give in the rows of Table 1."""

from pathlib import Path
from typing import List

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure

from ..experiment import Experiment
from ..neural import SETTLE_TICKS, Recording, table_recordings
from ..psn_row import switching
from .style import BLUE, GREY, PAGE, RULE, VERMILION, journal_style, letter, save, sign

_SHOWN = slice(SETTLE_TICKS, SETTLE_TICKS + 45)


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    rows = table_recordings(experiment)
    with journal_style():
        figure = plt.figure(figsize=(PAGE, 1.3 + 0.86 * len(rows)), layout="constrained")
        left, right = figure.subfigures(1, 2, width_ratios=[1.0, 1.0])
        _first_module(left, rows)
        _other_modules(right, rows)
        sign(figure, experiment.plan.trials[:1], f"network of {len(rows)} trials, one a row of Table 1")
        return save(figure, prefix)


def _first_module(panel: SubFigure, rows: List[Recording]) -> None:
    axes = panel.subplots(1 + len(rows), 1, sharex=True, sharey=True)
    _curves(axes[0], rows[0], "C1", None)
    letter(axes[0], "b", "inputs of PSN1: $C_1$ (line), $-C_1$ (dashed)")
    for axis, row in zip(axes[1:], rows):
        _curves(axis, row, "PSN1.P13", "PSN1.P14")
        axis.set_title(_title(row, "PSN1"), fontsize=7, pad=2)
    axes[1].set_title("(c) outputs of PSN1: $P_{13}$ (line), $P_{14}$ (dashed)\n" + _title(rows[0], "PSN1"),
                      fontsize=8, pad=2)
    axes[0].set_ylim(-1.05, 1.05)
    axes[0].set_yticks([-0.5, 0.5])
    axes[-1].set_xlabel("simulated time [s]")
    panel.supylabel("neuron output", fontsize=8)


def _other_modules(panel: SubFigure, rows: List[Recording]) -> None:
    modules = ("PSN2", "PSN3", "PSN4")
    axes = panel.subplots(1 + len(rows), len(modules), sharex=True, sharey=True)
    for column, module in enumerate(modules):
        axes[0][column].axis("off")
        axes[0][column].text(0.5, 0.12, f"{module}\n$P_{{13}}$, $P_{{14}}$", ha="center", va="bottom",
                             transform=axes[0][column].transAxes)
        for axis, row in zip(axes[1:, column], rows):
            _curves(axis, row, f"{module}.P13", f"{module}.P14")
            axis.set_title(switching(row, module).word, fontsize=7, pad=2, loc="center")
        axes[-1][column].set_xlabel("time [s]")
    axes[1][0].set_ylim(-0.62, 0.62)
    axes[1][0].set_yticks([-0.5, 0.5])


def _title(row: Recording, module: str) -> str:
    i1, i2 = (row.settled(name)[0] for name in ("I1", "I2"))
    return f"$I_{{1,2}}$ = ({i1:g}, {i2:g}) {row.row}: {switching(row, module).word}".replace("-", "−")


def _curves(axis: Axes, row: Recording, first: str, second: "str | None") -> None:
    """A second output, or the inverted first one."""
    one = row.neuron(first)[_SHOWN]
    other = row.neuron(second)[_SHOWN] if second else [-value for value in one]
    time_s = row.time_s[_SHOWN]
    axis.axhline(0, color=RULE, linewidth=0.5, zorder=0)
    if second is None or first.startswith("PSN"):
        axis.axhspan(-0.5, 0.5, color="#f1f1f1", zorder=-1, linewidth=0)
    axis.plot(time_s, one, color=BLUE, linewidth=1.1)
    axis.plot(time_s, other, color=VERMILION, linewidth=0.9, linestyle=(0, (3, 1.5)))
    axis.tick_params(axis="both", color=GREY)
