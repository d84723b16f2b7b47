"""Further than the paper: soft+hard, one parameter set, held-out seeds."""

from ..experiment import Experiment
from ..failure_detail import why_failed
from ..wording import counted, shown_height
from .finding import Finding, Source, Verdict, graded

STRATEGY = "soft+hard"
AIMS = ((0.12, 38 / 40), (0.14, 20 / 40))  # up to this height at least this share


def aim_at(height_m: float) -> "float | None":
    """Share that is aimed at; None where nothing is."""
    if 0 < height_m <= AIMS[0][0]:
        return AIMS[0][1]
    return AIMS[1][1] if height_m == AIMS[1][0] else None


def up_to_12_cm(experiment: Experiment) -> Finding:
    cells = [cell for cell in experiment.of(STRATEGY) if 0 < cell.key.height_m <= AIMS[0][0]]
    met = [cell.share >= AIMS[0][1] for cell in cells]
    missed = [cell for cell, good in zip(cells, met) if not good]
    reasons = [f"at {shown_height(cell.key.height_m)}: {why_failed([cell])}" for cell in missed]
    numbers = [f"{shown_height(cell.key.height_m)}: {counted(cell)}" for cell in cells]
    if cells:
        worst = min(cells, key=lambda cell: cell.share)
        numbers.insert(0, f"reached at {sum(met)} of {len(met)} heights; least: {worst.count} at "
                       f"{shown_height(worst.key.height_m)}")
    statement = "Soft then hard pushing succeeds in at least 38 of 40 trials at every height up to 12 cm."
    return Finding("up_to_12_cm", statement, graded(met), numbers, "; ".join(reasons), Source.AIM)


def at_14_cm(experiment: Experiment) -> Finding:
    cell = experiment.at(STRATEGY, AIMS[1][0])
    statement = "At 14 cm it succeeds in at least 20 of 40 trials."
    if cell is None:
        return Finding("at_14_cm", statement, Verdict.OPEN, [], source=Source.AIM)
    good = cell.share >= AIMS[1][1]
    return Finding("at_14_cm", statement, graded([good]), [counted(cell)],
                   "" if good else why_failed([cell]), Source.AIM)


FINDINGS = (up_to_12_cm, at_14_cm)
