"""Fig. 7: what the robot felt and did while it moved its object."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import List

import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from ..behaviour_signals import behaviour_signals
from ..experiment import Experiment
from ..signal_table import JOINT_SLOTS, SignalTable
from ..wording import perturbation, seeds, shown_height
from .style import PAGE, journal_style, save

# Tints of the Okabe-Ito palette: apart for colour-blind readers, and each lighter or darker than its
# neighbours when printed in grey.
_TINTS = {"APPROACH": "#f4f4f4", "CLIMB": "#cfe3f3", "MODE_1": "#fdeecb", "MODE_2": "#c4e0d5",
          "DONE": "#ffffff", "FAILED": "#f3d3c4", "SAFE_STOP": "#f3d3c4", "IDLE": "#ffffff"}
_LINE, _THRESHOLD, _EDGE, _NOTE = "#0b3c5d", "#b3401a", "#8a8a8a", "#555555"
_OTHER_TRIGGERS = {"SUPPLY_CURRENT": ("supply current", "current [A]"),
                   "FOOT_FORCE": ("force on the front feet", "force [N]")}
_ORIGIN_OF_ANGLES = {"COMMANDED": "as commanded: this robot does not measure the angles of its joints",
                     "ABSENT": "this robot does not tell the angles of its joints",
                     "MIXED": "some of these joints as commanded: they are not measured"}
_SHORT_SPAN_SHARE = 0.07  # of the time axis: a narrower span has its label upright

@dataclass(frozen=True)
class Span:
    """A stretch of one behaviour."""

    start_s: float
    end_s: float
    state: str
    mode: str

    def label(self) -> str:
        pattern = self.mode.replace("_", " ").lower()
        if self.state in ("MODE_1", "MODE_2"):
            return f"{self.state.replace('_', ' ').lower()}\n{pattern}"
        if self.state in ("APPROACH", "CLIMB"):
            return f"{self.state.lower()}\n{pattern}"
        return self.state.replace("_", " ").lower()


def spans(table: SignalTable) -> List[Span]:
    """The behaviours in the order of their time; each lasts until the next one starts."""
    found: List[Span] = []
    start = 0
    count = len(table.time_s)
    for i in range(1, count + 1):
        if i < count and table.state[i] == table.state[start]:
            continue
        end_s = table.time_s[min(i, count - 1)]
        # The pattern of its last tick: a behaviour may still be entered with the one before.
        found.append(Span(table.time_s[start], end_s, table.state[start], table.mode[i - 1]))
        start = i
    return found


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    """Of the trial that behaviour_signals chooses."""
    trial, table = behaviour_signals(experiment)
    note = "; ".join([trial.strategy, f"obstacle {shown_height(trial.height_m)}", perturbation([trial]),
                      seeds([trial])])
    return draw_signals(table, prefix, note)


def draw_signals(table: SignalTable, prefix: Path, note: str = "") -> List[Path]:
    """Writes <prefix>.svg and <prefix>.png; equal tables give equal files."""
    with journal_style():
        names = ["BS", "AS", *JOINT_SLOTS]
        figure, axes = plt.subplots(
            len(names), 1, sharex=True, figsize=(PAGE, 8.2),
            gridspec_kw={"height_ratios": [1.5, 1.5] + [1.0] * len(JOINT_SLOTS), "hspace": 0.22})
        behaviours = spans(table)
        for axis in axes:
            _shade(axis, behaviours)
        _draw_inclination(axes[0], table)
        _draw_trigger(axes[1], table)
        for axis, joint in zip(axes[2:], JOINT_SLOTS):
            _draw_angle(axis, table, joint)
        axes[2].set_title(_ORIGIN_OF_ANGLES.get(table.position_source, ""), loc="right", fontsize=7, pad=1.5,
                          color=_NOTE)
        _label_spans(axes[0], behaviours)
        axes[-1].set_xlabel("simulated time [s]")
        axes[-1].set_xlim(table.time_s[0], max(table.time_s[-1], table.time_s[0] + 0.1))
        figure.align_ylabels(axes)
        figure.subplots_adjust(left=0.11, right=0.98, top=0.93, bottom=0.07)
        if note:
            figure.text(0.01, 0.005, note, fontsize=6.5, color=_EDGE)
        return save(figure, prefix)


def _draw_inclination(axis: Axes, table: SignalTable) -> None:
    axis.set_ylabel("BS [deg]")
    if table.imu_source == "ABSENT":
        _say_instead(axis, "this robot does not measure its inclination")
        return
    _draw_signal(axis, table, "BS: body inclination", _degrees(table.signals["bs_rad"]),
                 _degrees(table.signals["bs_threshold_rad"]))


def _draw_trigger(axis: Axes, table: SignalTable) -> None:
    """The signal that tells of the obstacle: AS, or what a robot without joint angles has in its place."""
    if table.trigger in _OTHER_TRIGGERS:
        name, unit = _OTHER_TRIGGERS[table.trigger]
        axis.set_ylabel(unit)
        _draw_signal(axis, table, name, table.signals["trigger_value"], table.signals["trigger_threshold"])
        return
    axis.set_ylabel("AS [deg]")
    if table.position_source in ("ABSENT", "COMMANDED"):
        _say_instead(axis, "this robot does not measure the angles of its joints")
        return
    _draw_signal(axis, table, "AS: mean angle of the front F-joints", _degrees(table.signals["as_rad"]),
                 _degrees(table.signals["as_threshold_rad"]))


def _draw_signal(axis: Axes, table: SignalTable, name: str, value: List[float], threshold: List[float]) -> None:
    axis.plot(table.time_s, value, color=_LINE, linewidth=1.4, label=name)
    axis.plot(table.time_s, threshold, color=_THRESHOLD, linewidth=1.0, linestyle=(0, (5, 3)),
              label="threshold")
    axis.margins(y=0.12)
    axis.legend(loc="best", ncol=2, fontsize=7.5, framealpha=0.8, edgecolor="none", borderpad=0.3)


def _draw_angle(axis: Axes, table: SignalTable, joint: str) -> None:
    axis.plot(table.time_s, _degrees(table.signals[f"{joint}_rad"]), color=_LINE, linewidth=1.0)
    axis.set_ylabel(f"{joint} [deg]")
    axis.yaxis.set_major_locator(plt.MaxNLocator(3))
    axis.margins(y=0.15)


def _say_instead(axis: Axes, text: str) -> None:
    axis.text(0.5, 0.5, text, transform=axis.transAxes, fontsize=8, color=_NOTE, ha="center", va="center")
    axis.set_yticks([])


def _shade(axis: Axes, behaviours: List[Span]) -> None:
    for span in behaviours:
        axis.axvspan(span.start_s, span.end_s, color=_TINTS.get(span.state, "#ffffff"),
                     linewidth=0, zorder=-2)
        if span is not behaviours[0]:
            axis.axvline(span.start_s, color=_EDGE, linewidth=0.6, zorder=-1)


def _label_spans(axis: Axes, behaviours: List[Span]) -> None:
    whole_s = behaviours[-1].end_s - behaviours[0].start_s
    for span in behaviours:
        share = (span.end_s - span.start_s) / whole_s if whole_s else 0.0
        if share == 0.0:
            continue  # the last tick alone
        narrow = share < _SHORT_SPAN_SHARE
        text = span.state.replace("_", " ").lower() if narrow else span.label()
        axis.annotate(text, ((span.start_s + span.end_s) / 2, 1), xytext=(0, 4), ha="center",
                      xycoords=("data", "axes fraction"), textcoords="offset points", va="bottom",
                      fontsize=8, rotation=90 if narrow else 0)


def _degrees(radians: List[float]) -> List[float]:
    return [math.degrees(angle) for angle in radians]
