"""Fig. 2: outputs of the central pattern generator over time, and its phase portrait."""

import math
from pathlib import Path
from typing import List

import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from ..experiment import Experiment
from ..failure import ReportError
from ..findings.neural import cpg
from ..neural import SETTLE_TICKS
from ..oscillation import amplitude
from .style import BLUE, GREY, INK, PAGE, RULE, VERMILION, journal_style, letter, save, sign

_SHOWN_TICKS = 70


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    found, orbit, c1, c2 = cpg(experiment)
    if math.isinf(orbit.period_ticks):
        raise ReportError("the outputs of the CPG do not turn about the origin")
    with journal_style():
        figure, (time, phase) = plt.subplots(1, 2, figsize=(PAGE, 2.75), layout="constrained",
                                             gridspec_kw={"width_ratios": [1.75, 1.0]})
        time_s = found.time_s[SETTLE_TICKS:]
        _over_time(time, time_s, c1, c2, 0.1 * orbit.period_ticks)
        _portrait(phase, c1, c2, int(orbit.period_ticks))
        letter(time, "a", f"period {orbit.period_ticks:.2f} ticks of 0.1 s, amplitude {amplitude(c1):.2f}")
        letter(phase, "b", f"{len(c1)} states, " + ("some repeat" if orbit.repeats else "none repeats"))
        sign(figure, experiment.plan.trials[:1])
        return save(figure, prefix)


def _over_time(axis: Axes, time_s: List[float], c1: List[float], c2: List[float], period_s: float) -> None:
    shown = slice(0, _SHOWN_TICKS)
    axis.plot(time_s[shown], c1[shown], color=BLUE, marker="o", markersize=2.4, label="$C_1$ (drives the joints)")
    axis.plot(time_s[shown], c2[shown], color=VERMILION, linestyle=(0, (4, 2)), marker="s", markersize=2.2,
              markerfacecolor="white", markeredgewidth=0.6, label="$C_2$")
    axis.set_xlabel("simulated time [s]")
    axis.set_ylabel("neuron output")
    axis.set_ylim(-1.1, 1.45)
    axis.set_yticks([-1, -0.5, 0, 0.5, 1])
    axis.legend(loc="upper right", ncol=2)
    start = time_s[0] + period_s / 4
    axis.annotate("", (start, 1.12), (start + period_s, 1.12), arrowprops={"arrowstyle": "<->", "linewidth": 0.6})
    axis.annotate("one period", (start + period_s / 2, 1.15), ha="center", va="bottom", fontsize=7)
    axis.axhline(0, color=RULE, linewidth=0.5, zorder=0)


def _portrait(axis: Axes, c1: List[float], c2: List[float], turn: int) -> None:
    """All states, and one turn with the direction of time."""
    axis.plot(c1, c2, linestyle="", marker=".", markersize=2.0, color=GREY)
    axis.plot(c1[:turn], c2[:turn], color=BLUE, linewidth=0.6, marker="o", markersize=2.4)
    for i in range(0, turn - 1, 2):
        axis.annotate("", (c1[i + 1], c2[i + 1]), (c1[i], c2[i]),
                      arrowprops={"arrowstyle": "-|>", "linewidth": 0.6, "color": INK, "mutation_scale": 7})
    axis.set_aspect("equal")
    axis.set_xlim(-1.1, 1.1)
    axis.set_ylim(-1.1, 1.1)
    axis.set_xticks([-1, 0, 1])
    axis.set_yticks([-1, 0, 1])
    axis.set_xlabel("$C_1$")
    axis.set_ylabel("$C_2$", labelpad=0)
