"""The paper's first experiment: pushing 1.46 m over the flat (Fig. 5)."""

import math
from typing import List, Optional

from ..cells import Cell, pooled
from ..exact_tests import rank_sum_p, shown_p
from ..experiment import Experiment
from ..failure_detail import why_failed
from ..intervals import mean
from ..trial import is_loss
from ..wording import counted, spread
from .finding import HALF, Finding, Verdict, does_the_job, graded

_SLOWER = ("boxing", "stationary")


def _flat(experiment: Experiment, strategy: str) -> Optional[Cell]:
    cells = [cell for cell in experiment.of(strategy) if cell.key.height_m == 0]
    return pooled(cells) if cells else None


def soft_fastest(experiment: Experiment) -> Finding:
    soft = _flat(experiment, "soft")
    others = [cell for strategy in (*_SLOWER, "hard") if (cell := _flat(experiment, strategy))]
    rivals = [cell for cell in others if does_the_job(cell)]
    numbers = [f"{cell.key.strategy}: {spread(cell.times_s)}, {counted(cell)}" for cell in [soft, *others] if cell]
    statement = "Soft pushing moves the object over the flat fastest of all modes."
    if not soft or not others:
        return Finding("soft_fastest", statement, Verdict.OPEN, numbers)
    if not does_the_job(soft):
        return Finding("soft_fastest", statement, Verdict.DIFFERS, numbers,
                       f"soft pushing does not arrive in half of its trials: {why_failed([soft])}")
    numbers += [f"soft before {cell.key.strategy}: {shown_p(rank_sum_p(soft.times_s, cell.times_s))} "
                f"(exact rank sum test, one-sided, {len(soft.times_s)} against {len(cell.times_s)} arrivals)"
                for cell in rivals]
    if not rivals:
        return Finding("soft_fastest", statement, Verdict.PARTLY, numbers,
                       "no other mode arrives in half of its trials, so there is no time to compare with")
    met = [mean(soft.times_s) < mean(cell.times_s) for cell in rivals]
    reasons = [_faster(cell, soft) for cell, good in zip(rivals, met) if not good]
    return Finding("soft_fastest", statement, graded(met), numbers, "; ".join(reasons))


def _faster(cell: Cell, soft: Cell) -> str:
    return (f"{cell.key.strategy} is {mean(soft.times_s) - mean(cell.times_s):.1f} s faster in the mean: it moves the "
            f"object at {_speed(cell)}, soft pushing at {_speed(soft)}")


def _speed(cell: Cell) -> str:
    speed = mean([trial.object_travel_m / trial.time_s for trial in cell.trials if trial.success])
    return f"{speed:.3f} m/s"


def others_arrive(experiment: Experiment) -> Finding:
    soft = _flat(experiment, "soft")
    cells = [cell for strategy in _SLOWER if (cell := _flat(experiment, strategy))]
    reasons: List[str] = []
    met = []
    for cell in cells:
        slower = bool(soft and soft.times_s and cell.times_s) and mean(cell.times_s) > mean(soft.times_s)
        met.append(does_the_job(cell) and slower)
        if not does_the_job(cell):
            reasons.append(f"{cell.key.strategy} fails more often than not: {why_failed([cell])}")
        elif not slower:
            reasons.append(f"{cell.key.strategy} is not slower than soft pushing")
    return Finding("others_arrive", "Boxing and stationary bring the object to the end point, too, but need more time.",
                   graded(met if soft else [], any(map(does_the_job, cells))),
                   [f"{cell.key.strategy}: {counted(cell)} arrive, {spread(cell.times_s)}" for cell in cells],
                   "; ".join(reasons))


def hard_fails(experiment: Experiment) -> Finding:
    statement = ("Hard pushing alone is not suited to the flat: it pushes the object away in an arbitrary direction "
                 "(here: object or direction lost in at least half of the trials).")
    hard = _flat(experiment, "hard")
    if not hard:
        return Finding("hard_fails", statement, Verdict.OPEN, [])
    losses = sum(map(is_loss, hard.trials))
    turned = [abs(math.degrees(trial.heading_rad)) for trial in hard.trials]
    numbers = [f"{counted(hard)} arrive", f"{losses}/{hard.n} lose the object or fall",
               f"in the end the robot has turned by {min(turned):.0f}° to {max(turned):.0f}°"]
    if kinds := why_failed([hard]):
        numbers.append(f"failures: {kinds}")
    if losses >= HALF * hard.n:
        return Finding("hard_fails", statement, Verdict.AGREES, numbers)
    failed_at_all = hard.share < HALF
    return Finding("hard_fails", statement, Verdict.PARTLY if failed_at_all else Verdict.DIFFERS, numbers,
                   "it fails, but by the time limit rather than by losing the object" if failed_at_all else
                   "hard pushing keeps object and direction in more than half of the trials")


FINDINGS = (soft_fastest, others_arrive, hard_fails)
