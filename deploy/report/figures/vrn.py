"""Fig. 4 b-e: what the velocity regulating networks give in the rows of Table 1."""

from pathlib import Path
from typing import List

import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from ..experiment import Experiment
from ..failure import ReportError
from ..neural import SETTLE_TICKS, Recording, table_recordings
from ..oscillation import amplitude
from .style import BLUE, PAGE, RULE, VERMILION, journal_style, letter, save, sign

_SHOWN = slice(SETTLE_TICKS, SETTLE_TICKS + 45)
# The paper's panels: letter, title, rows of Table 1.
_PANELS = (("b", "walking", ("table-forward", "table-backward")), ("c", "hard pushing", ("table-hard-push",)),
           ("d", "soft pushing", ("table-soft-push",)), ("e", "boxing-like motion", ("table-boxing",)))
_OUTPUTS = (("VRN1.V7", "hind C-joints"), ("VRN2.V7", "hind T-joints"))


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    rows = {row.strategy: row for row in table_recordings(experiment)}
    panels = [panel for panel in _PANELS if any(name in rows for name in panel[2])]
    if not panels:
        raise ReportError("no row of Table 1 that the figure shows was run")
    with journal_style():
        figure, axes = plt.subplots(2, len(panels), sharex=True, sharey="row", squeeze=False,
                                    figsize=(PAGE, 3.5), layout="constrained")
        for column, (name, title, strategies) in enumerate(panels):
            for line, (neuron, _) in enumerate(_OUTPUTS):
                _panel(axes[line][column], [rows[s] for s in strategies if s in rows], neuron)
            letter(axes[0][column], name, title)
            axes[-1][column].set_xlabel("simulated time [s]")
        for line, (neuron, joints) in enumerate(_OUTPUTS):
            axes[line][0].set_ylabel(f"{neuron.split('.')[0]} output $V_7$\n({joints})")
        sign(figure, experiment.plan.trials[:1], "one trial a row of Table 1")
        return save(figure, prefix)


def _panel(axis: Axes, rows: List[Recording], neuron: str) -> None:
    looks = ((BLUE, "-", "o"), (VERMILION, (0, (3, 1.5)), "s"))
    axis.axhline(0, color=RULE, linewidth=0.5, zorder=0)
    for row, (colour, style, marker) in zip(rows, looks):
        label = row.strategy.replace("table-", "")
        axis.plot(row.time_s[_SHOWN], row.neuron(neuron)[_SHOWN], color=colour, linestyle=style, marker=marker,
                  markersize=2.0, markevery=3, linewidth=1.0, label=label)
    amplitudes = dict.fromkeys(f"{amplitude(row.settled(neuron)):.2f}" for row in rows)  # equal ones once
    axis.text(0.03, 0.97, f"amplitude {', '.join(amplitudes)}", transform=axis.transAxes, fontsize=7, va="top")
    axis.margins(y=0.32)
    if len(rows) > 1:
        axis.legend(loc="lower center", ncol=2, fontsize=6.5, handlelength=1.8, columnspacing=0.8, borderpad=0)
