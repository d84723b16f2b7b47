"""Over objects and ground that differ from those of the search: no statement of the paper."""

from typing import Iterable

from ..cells import Cell
from ..experiment import Experiment
from ..failure_detail import why_failed
from ..grids import friction_by_mass, mass_by_diameter
from ..wording import conditions, counted
from .finding import Finding, Source, does_the_job, graded


def _holds(name: str, what: str, cells: Iterable[Cell]) -> Finding:
    run = [cell for cell in cells if cell.n]
    failing = sorted((cell for cell in run if not does_the_job(cell)), key=lambda cell: cell.share)
    best_first = sorted(run, key=lambda cell: -cell.share)
    numbers = [f"{len(run) - len(failing)}/{len(run)} cells succeed in at least half of their trials"] if run else []
    numbers += [f"worst: {conditions(cell.key)}: {counted(cell)}" for cell in best_first[-1:]]
    return Finding(name, f"Success in at least half of the trials over {what}.",
                   graded([does_the_job(cell) for cell in run]), numbers,
                   f"where it fails: {why_failed(failing)}" if failing else "", Source.AIM)


def object_changes(experiment: Experiment) -> Finding:
    return _holds("mass_and_diameter", "masses and diameters of the object", mass_by_diameter(experiment).cells)


def friction_changes(experiment: Experiment) -> Finding:
    return _holds("friction_and_mass", "friction and mass", friction_by_mass(experiment).cells)


FINDINGS = (object_changes, friction_changes)
