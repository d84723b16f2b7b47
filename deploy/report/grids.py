"""Cells laid out over two of their conditions."""

from dataclasses import dataclass
from typing import Callable, Dict, List, Optional, Tuple

from .cells import Cell
from .experiment import Experiment
from .trial import CellKey


@dataclass(frozen=True)
class Grid:
    """Rows and columns are the values that occur, in order; a place may have no cell."""

    rows: List[float]
    columns: List[float]
    at: Dict[Tuple[float, float], Cell]

    @property
    def cells(self) -> List[Cell]:
        return list(self.at.values())

    def cell(self, row: float, column: float) -> Optional[Cell]:
        return self.at.get((row, column))


def mass_by_diameter(experiment: Experiment) -> Grid:
    """Of the cells with the friction as configured; where diameters are said, of those."""
    cells = [cell for cell in experiment.cells if cell.key.friction_scale == 1]
    said = [cell for cell in cells if cell.key.object_diameter_m]
    return _grid(said or cells, lambda key: (key.object_mass_kg, key.object_diameter_m))


def friction_by_mass(experiment: Experiment) -> Grid:
    """Of the diameter that was run with more than one friction."""
    frictions: Dict[float, set] = {}
    for cell in experiment.cells:
        frictions.setdefault(cell.key.object_diameter_m, set()).add(cell.key.friction_scale)
    diameter = max(frictions, key=lambda value: len(frictions[value]))
    return _grid([cell for cell in experiment.cells if cell.key.object_diameter_m == diameter],
                 lambda key: (key.friction_scale, key.object_mass_kg))


def _grid(cells: List[Cell], place: Callable[[CellKey], Tuple[float, float]]) -> Grid:
    at = {place(cell.key): cell for cell in cells}
    return Grid(sorted({row for row, _ in at}), sorted({column for _, column in at}), at)
