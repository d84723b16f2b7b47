"""How all figures look: for print at column width, readable in grey, the same bytes for the same data."""

import textwrap
from contextlib import contextmanager
from pathlib import Path
from typing import Dict, Iterator, List, Tuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

from ..trial import Conditions  # noqa: E402
from ..wording import perturbation, seeds  # noqa: E402

# Inches; of a journal with two columns.
COLUMN, PAGE = 3.5, 7.2
# Okabe-Ito colours in the order of their lightness in print, darkest first.
INK, BLUE, VERMILION, ORANGE, PALE = "#1b1b1b", "#0072b2", "#d55e00", "#e69f00", "#f0e442"
GREY, RULE = "#6e6e6e", "#c9c9c9"
_SMALL_PRINT = 6.5
_SETTINGS = {
    "font.family": "DejaVu Sans", "font.size": 8, "axes.labelsize": 8, "axes.titlesize": 8,
    "xtick.labelsize": 7.5, "ytick.labelsize": 7.5, "legend.fontsize": 7.5, "axes.linewidth": 0.6,
    "axes.spines.top": False, "axes.spines.right": False, "axes.titlelocation": "left",
    "xtick.major.width": 0.6, "ytick.major.width": 0.6, "xtick.major.size": 2.5, "ytick.major.size": 2.5,
    "lines.linewidth": 1.1, "lines.markersize": 3.5, "hatch.linewidth": 0.6, "legend.frameon": False,
    "legend.handlelength": 2.2, "svg.fonttype": "path", "svg.hashsalt": "scarab", "figure.dpi": 220}


@contextmanager
def journal_style() -> Iterator[None]:
    with plt.rc_context(_SETTINGS):
        yield


def save(figure: Figure, prefix: Path) -> List[Path]:
    """<prefix>.svg and <prefix>.png, without date or program; the figure is closed."""
    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # it has done its work: once, not for each file
    files = [Path(f"{prefix}.svg"), Path(f"{prefix}.png")]
    figure.savefig(files[0], metadata={"Date": None, "Creator": None})
    figure.savefig(files[1], metadata={"Software": None})
    plt.close(figure)
    return files


def sign(figure: Figure, trials: List[Conditions], *more: str) -> None:
    """What was perturbed, in small print below the panels."""
    text = "; ".join([*more, perturbation(trials), seeds(trials)])
    columns = int(figure.get_size_inches()[0] / (_SMALL_PRINT * 0.56 / 72))
    figure.supxlabel("\n".join(textwrap.wrap(text, columns)), fontsize=_SMALL_PRINT, color=GREY, x=0.01, ha="left")


def letter(axis: Axes, text: str, title: str = "") -> None:
    """(a), (b), ... above the panel's left corner."""
    axis.set_title(f"({text}) {title}".rstrip(), loc="left")


# Of a mode: colour, marker, hatch. Modes differ in each of them, and in lightness.
MODES: Dict[str, Tuple[str, str, str]] = {
    "soft": (BLUE, "o", ""), "boxing": (ORANGE, "s", "///"), "stationary": (PALE, "^", "..."),
    "hard": (VERMILION, "D", "xx"), "walk-forward": (BLUE, ">", ""), "walk-backward": (VERMILION, "<", "//")}


def mode_style(strategy: str) -> Tuple[str, str, str]:
    """Of a combination: that of its first mode."""
    return MODES.get(strategy.split("+")[0], (GREY, "v", "\\\\"))
