"""The figure of each kind of experiment."""

from pathlib import Path
from typing import Callable, Dict, List

from ..experiment import Experiment
from . import beyond, cpg, obstacle, psn, robustness, sequence, transport_speed, vrn, walking

DRAWINGS: Dict[str, Callable[[Experiment, Path], List[Path]]] = {
    "cpg": cpg.draw, "psn": psn.draw, "vrn": vrn.draw, "transport_speed": transport_speed.draw,
    "obstacle": obstacle.draw, "sequence": sequence.draw, "walking": walking.draw, "beyond": beyond.draw,
    "robustness": robustness.draw}


def draw_figures(experiment: Experiment, directory: Path) -> List[Path]:
    """Writes <name>.svg and <name>.png. ReportError where the data are missing."""
    return DRAWINGS[experiment.plan.figure](experiment, directory / experiment.plan.name)
