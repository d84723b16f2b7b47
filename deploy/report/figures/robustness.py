"""Success over objects and ground that differ from those of the search."""

from pathlib import Path
from typing import Callable, List

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from ..experiment import Experiment
from ..failure import ReportError
from ..grids import Grid, friction_by_mass, mass_by_diameter
from .style import GREY, INK, PAGE, journal_style, letter, save, sign


def draw(experiment: Experiment, prefix: Path) -> List[Path]:
    if not experiment.trials:
        raise ReportError("no trial has been run yet")
    grids = (mass_by_diameter(experiment), friction_by_mass(experiment))
    sizes = [(len(grid.rows), len(grid.columns)) for grid in grids]
    with journal_style():
        figure, axes = plt.subplots(1, 2, figsize=(PAGE, 0.95 + 0.4 * max(rows for rows, _ in sizes)),
                                    layout="constrained", gridspec_kw={"width_ratios": [size[1] for size in sizes]})
        for axis, grid in zip(axes, grids):
            _map(axis, grid)
        _name(axes[0], grids[0], "mass of the object [kg]", _plain, "diameter of the object [cm]", _centimetres)
        _name(axes[1], grids[1], "friction, × configured", _plain, "mass of the object [kg]", _plain)
        letter(axes[0], "a", "mass and diameter")
        letter(axes[1], "b", "friction and mass")
        first = experiment.plan.trials[0]
        sign(figure, experiment.plan.trials, f"{first.strategy}, {100 * first.height_m:g} cm obstacle")
        return save(figure, prefix)


def _map(axis: Axes, grid: Grid) -> None:
    """The darker the more succeed; a cell without a trial is crossed out."""
    for row, row_value in enumerate(grid.rows):
        for column, column_value in enumerate(grid.columns):
            cell = grid.cell(row_value, column_value)
            corner = (column - 0.5, row - 0.5)
            if cell is None or not cell.n:
                axis.add_patch(Rectangle(corner, 1, 1, facecolor="white", edgecolor=GREY, hatch="xxx", linewidth=0.4))
                continue
            shade = plt.get_cmap("Blues")(0.05 + 0.85 * cell.share)
            axis.add_patch(Rectangle(corner, 1, 1, facecolor=shade, edgecolor="white", linewidth=1.2))
            axis.annotate(cell.count, (column, row), ha="center", va="center",
                          color="white" if cell.share > 0.6 else INK)
    axis.set_xlim(-0.5, len(grid.columns) - 0.5)
    axis.set_ylim(-0.5, len(grid.rows) - 0.5)
    axis.tick_params(length=0)
    for spine in axis.spines.values():
        spine.set_visible(False)


def _name(axis: Axes, grid: Grid, rows: str, of_row: Callable[[float], str], columns: str,
          of_column: Callable[[float], str]) -> None:
    axis.set_yticks(range(len(grid.rows)), map(of_row, grid.rows))
    axis.set_xticks(range(len(grid.columns)), map(of_column, grid.columns))
    axis.set_ylabel(rows)
    axis.set_xlabel(columns)


def _plain(value: float) -> str:
    return f"{value:g}" if value else "as configured"


def _centimetres(value: float) -> str:
    return f"{100 * value:g}" if value else "as configured"
