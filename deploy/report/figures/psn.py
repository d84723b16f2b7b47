"""Fig. 3 b, c: what the phase switching networks get and give in the rows of Table 1."""

from pathlib import Path
from typing import List, Sequence

import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from ..experiment import Experiment
from ..neural import SETTLE_TICKS, Recording, table_recordings
from ..psn_row import switching
from .style import BLUE, GREY, PAGE, RULE, VERMILION, journal_style, letter, save, sign

_MODULES = ("PSN2", "PSN3", "PSN4")
_SHOWN = slice(SETTLE_TICKS, SETTLE_TICKS + 45)


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    rows = table_recordings(experiment)
    with journal_style():
        figure, axes = plt.subplots(1 + len(rows), 1 + len(_MODULES), sharex=True, sharey="col", squeeze=False,
                                    figsize=(PAGE, 0.95 + 0.92 * len(rows)), layout="constrained",
                                    gridspec_kw={"width_ratios": [2.6, *(1 for _ in _MODULES)]})
        _first_module(axes[:, 0], rows)
        for column, module in enumerate(_MODULES):
            _further_module(axes[:, 1 + column], rows, module)
        for axis in axes[-1]:
            axis.set_xlabel("simulated time [s]" if axis is axes[-1][0] else "time [s]")
        figure.supylabel("neuron output", fontsize=8)
        sign(figure, experiment.plan.trials[:1], f"network of {len(rows)} trials, one a row of Table 1")
        return save(figure, prefix)


def _first_module(axes: Sequence[Axes], rows: List[Recording]) -> None:
    _curves(axes[0], rows[0], "C1", None)
    letter(axes[0], "b", "inputs of PSN1: $C_1$ (line), $-C_1$ (dashed)")
    for axis, row in zip(axes[1:], rows):
        _curves(axis, row, "PSN1.P13", "PSN1.P14")
        axis.set_title(_title(row), fontsize=7.5, pad=2)
    caption = "(c) outputs of PSN1: $P_{13}$ (line), $P_{14}$ (dashed)"
    axes[1].set_title(f"{caption}\n{_title(rows[0])}", fontsize=7.5, pad=2)
    axes[0].set_ylim(-1.05, 1.05)
    axes[0].set_yticks([-0.5, 0.5])


def _further_module(axes: Sequence[Axes], rows: List[Recording], module: str) -> None:
    axes[0].axis("off")
    axes[0].text(0.5, 0.0, f"{module}\n$P_{{13}}$, $P_{{14}}$", ha="center", va="bottom", transform=axes[0].transAxes)
    for axis, row in zip(axes[1:], rows):
        _curves(axis, row, f"{module}.P13", f"{module}.P14")
        axis.set_title(switching(row, module).word, fontsize=7.5, pad=2, loc="center")
    axes[1].set_ylim(-1.05, 1.05)
    axes[1].set_yticks([-0.5, 0.5], [])


def _title(row: Recording) -> str:
    inputs = ", ".join(f"{row.settled(name)[0]:g}" for name in ("I1", "I2")).replace("-", "−")
    return f"$I_{{1,2}}$ = ({inputs}), {row.row}: {switching(row, 'PSN1').word}"


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
