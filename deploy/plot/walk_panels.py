"""The panels of a walk: from above on the left, the gait on the right."""

from pathlib import Path
from typing import Dict, List, Tuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

from walk_table import LEGS, Walk  # noqa: E402

# Colours of the Okabe-Ito palette, one for each tripod; apart in grey as well.
_TRIPODS = {"L0": "#0072b2", "R1": "#0072b2", "L2": "#0072b2",
            "R0": "#d55e00", "L1": "#d55e00", "R2": "#d55e00"}
_MARKS = {"0": "^", "1": "o", "2": "v"}  # front, middle, hind
_GAIT_S = 8.0  # of the end of the trial
_STYLE = {"font.size": 8.5, "font.family": "DejaVu Sans", "axes.linewidth": 0.6,
          "axes.spines.top": False, "axes.spines.right": False, "svg.hashsalt": "scarab-walk",
          "svg.fonttype": "path", "xtick.major.width": 0.6, "ytick.major.width": 0.6}


def stances(walk: Walk, leg: int) -> List[Tuple[int, int]]:
    """First and last sample of each time that the foot stood on the ground."""
    found: List[Tuple[int, int]] = []
    for i, sample in enumerate(walk.samples):
        if leg not in sample.feet_m:
            continue
        if found and found[-1][1] == i - 1:
            found[-1] = (found[-1][0], i)
        else:
            found.append((i, i))
    return found


def draw(walks: Dict[str, Walk], prefix: Path) -> None:
    """Writes <prefix>.svg and <prefix>.png; equal walks give equal files."""
    with plt.rc_context(_STYLE):
        figure, axes = plt.subplots(
            len(walks), 2, figsize=(9.0, 0.5 + 2.1 * len(walks)), squeeze=False,
            gridspec_kw={"width_ratios": [1.7, 1.0]}, layout="constrained")
        for (name, walk), (above, gait) in zip(walks.items(), axes):
            _draw_from_above(above, name, walk)
            _draw_gait(gait, walk)
        axes[-1][0].set_xlabel("along the first heading [m]")
        axes[-1][1].set_xlabel("simulated time [s]")
        marks = [Line2D([], [], linestyle="", marker=mark, color="#606060", markersize=4,
                        label=f"{row} foot")
                 for row, mark in zip(("front", "middle", "hind"), _MARKS.values())]
        axes[0][0].legend(handles=marks, loc="upper left", ncol=3, fontsize=7, framealpha=0.8,
                          edgecolor="none", handletextpad=0.1, columnspacing=0.8)
        figure.savefig(prefix.with_suffix(".svg"), metadata={"Date": None})
        figure.savefig(prefix.with_suffix(".png"), dpi=130, metadata={"Software": None})
        plt.close(figure)


def _draw_from_above(axis: Axes, name: str, walk: Walk) -> None:
    for leg, label in enumerate(LEGS):
        # Where the foot came to stand: the middle of each stance, for feet slip a little.
        prints = [walk.samples[(first + last) // 2].feet_m[leg] for first, last in stances(walk, leg)
                  if last > first]
        axis.plot([x for x, _ in prints], [y for _, y in prints], linestyle="", markersize=3,
                  marker=_MARKS[label[1]], color=_TRIPODS[label], alpha=0.8)
    places = [sample.place_m for sample in walk.samples]
    axis.plot(*zip(*places), color="#202020", linewidth=1.2)
    axis.plot(*places[0], marker="o", color="#202020", markersize=4)
    axis.axhline(0, color="#b0b0b0", linewidth=0.6, zorder=-1)
    axis.set_aspect("equal", adjustable="datalim")
    axis.set_title(f"{name}: {walk.speed_m_s:+.3f} m/s, turned {walk.turned_deg:+.0f} deg "
                   f"in {walk.time_s:.0f} s", fontsize=8.5, loc="left")
    axis.set_ylabel("to the left [m]")


def _draw_gait(axis: Axes, walk: Walk) -> None:
    end_s = walk.samples[-1].time_s
    for row, label in enumerate(reversed(LEGS)):
        bars = [(walk.samples[first].time_s, walk.samples[last].time_s - walk.samples[first].time_s)
                for first, last in stances(walk, LEGS.index(label))]
        axis.broken_barh(bars, (row - 0.35, 0.7), color=_TRIPODS[label], linewidth=0)
    axis.set_yticks(range(len(LEGS)), reversed(LEGS))
    axis.set_xlim(max(0.0, end_s - _GAIT_S), end_s)
    axis.set_title("feet on the ground", fontsize=8.5, loc="left")
