"""The paper's second experiment: across an obstacle (Fig. 6)."""

from dataclasses import dataclass
from typing import Callable, List, Optional, Tuple

from ..exact_tests import shown_p, sign_p
from ..experiment import Experiment
from ..failure_detail import why_failed
from ..intervals import mean
from ..trial import Trial
from ..wording import centimetres, counted, shown_height
from .finding import Finding, Source, Verdict, does_the_job, graded

BASES = ("soft", "boxing", "stationary")
COMBINATIONS = tuple(f"{base}+hard" for base in BASES)
_PAPER_HIGHEST_M = 0.10
_BEST = "soft+hard"
_CHANCE = 0.05  # what is more probable than this without any difference shows none


@dataclass(frozen=True)
class Pairs:
    """Trials of two strategies at the same height and from the same seed."""

    of: List[Tuple[Trial, Trial]]

    def won(self, better: Callable[[Trial, Trial], bool]) -> Tuple[int, int]:
        """How many pairs the first one wins, how many the second one."""
        return sum(better(a, b) for a, b in self.of), sum(better(b, a) for a, b in self.of)


def pairs(experiment: Experiment, first: str, second: str) -> Pairs:
    def by_start(strategy: str) -> dict:
        return {(cell.key.height_m, trial.asked.seed): trial
                for cell in experiment.of(strategy) for trial in cell.trials}

    a, b = by_start(first), by_start(second)
    return Pairs([(a[start], b[start]) for start in sorted(a.keys() & b.keys())])


def combinations_beat_single(experiment: Experiment) -> Finding:
    statement = "Each mode does better across the obstacle when hard pushing follows than alone."
    met, numbers, reasons = [], [], []
    for base, combination in zip(BASES, COMBINATIONS):
        found = pairs(experiment, combination, base)
        if not found.of:
            continue
        won, lost = found.won(lambda a, b: a.success and not b.success)
        totals = [sum(pair[i].success for pair in found.of) for i in (0, 1)]
        shown = f"{combination} {totals[0]}/{len(found.of)}, {base} alone {totals[1]}/{len(found.of)}"
        if totals in ([0, 0], [len(found.of)] * 2):
            numbers.append(f"{shown}: nothing to tell them apart by")
            continue
        met.append(totals[0] > totals[1])
        numbers.append(f"{shown}; of the pairs that differ {won} to {lost} ({shown_p(sign_p(won, lost))}, exact sign "
                       "test)")
        if not met[-1]:
            kinds = why_failed(experiment.of(combination))
            why = f"; it fails by: {kinds}" if kinds else ""
            reasons.append(f"{combination} is no better than {base} alone{why}")
    return Finding("combinations_beat_single", statement, graded(met), numbers, "; ".join(reasons))


def soft_hard_fastest(experiment: Experiment) -> Finding:
    statement = "Of the combinations, soft then hard pushing takes the least time."
    met, numbers, reasons = [], [], []
    for rival in COMBINATIONS:
        found = pairs(experiment, _BEST, rival) if rival != _BEST else Pairs([])
        both = Pairs([(a, b) for a, b in found.of if a.success and b.success])
        if not both.of:
            if found.of:
                numbers.append(f"{rival}: no start from which both succeed")
            continue
        won, lost = both.won(lambda a, b: a.time_s < b.time_s)
        later = mean([b.time_s - a.time_s for a, b in both.of])
        met.append(later > 0)
        numbers.append(f"{rival} takes {abs(later):.1f} s {'more' if later > 0 else 'less'} in the mean over "
                       f"{len(both.of)} starts from which both succeed: {_BEST} is faster in {won}, slower in {lost} "
                       f"({shown_p(sign_p(won, lost))}, exact sign test)")
        if not met[-1]:
            chance = sign_p(lost, won) > _CHANCE  # that the rival wins so often
            reasons.append(f"{rival} takes as long from the same starts, as far as so many trials can tell" if chance
                           else f"{rival} is faster from the same starts")
    return Finding("soft_hard_fastest", statement, graded(met), numbers, "; ".join(reasons))


def up_to_10_cm(experiment: Experiment) -> Optional[Finding]:
    if _PAPER_HIGHEST_M not in experiment.heights_m:
        return None
    met, numbers, reasons = [], [], []
    for combination in COMBINATIONS:
        at_limit = experiment.at(combination, _PAPER_HIGHEST_M)
        if at_limit is None:
            continue
        met.append(does_the_job(at_limit))
        numbers.append(f"{combination} at 10 cm: {counted(at_limit)}; highest with at least half: "
                       f"{_shown(highest(experiment, combination))}")
        if not met[-1]:
            reasons.append(f"{combination} fails at 10 cm by: {why_failed([at_limit])}")
    numbers += [f"{base} alone: highest with at least half: {_shown(highest(experiment, base))}"
                for base in BASES if experiment.of(base)]
    statement = ("The combinations bring the object across obstacles of up to 10 cm (judged here: in at least half of "
                 "the trials at 10 cm).")
    return Finding("up_to_10_cm", statement, graded(met), numbers if met else [], "; ".join(reasons))


def beyond_10_cm(experiment: Experiment) -> Optional[Finding]:
    """Heights that the paper did not reach, or did not try."""
    higher = [height for height in experiment.heights_m if height > _PAPER_HIGHEST_M]
    if not higher:
        return None
    met, numbers = [], []
    for strategy in (*COMBINATIONS, *BASES):
        cells = [cell for cell in experiment.of(strategy) if cell.key.height_m in higher]
        if strategy in COMBINATIONS:
            met += [does_the_job(cell) for cell in cells]
        if cells:
            numbers.append(f"{strategy}: " + ", ".join(f"{cell.count} at {shown_height(cell.key.height_m)}"
                                                       for cell in cells))
    verdict = Verdict.OPEN if not met else Verdict.AGREES if any(met) else Verdict.DIFFERS
    combined = [cell for name in COMBINATIONS for cell in experiment.of(name) if cell.key.height_m in higher]
    statement = "A combination crosses more than the paper's 10 cm, in at least half of the trials at some height."
    return Finding("beyond_10_cm", statement, verdict, numbers, "" if any(met) else why_failed(combined), Source.AIM)


def highest(experiment: Experiment, strategy: str) -> Optional[float]:
    """The highest obstacle that is crossed in at least half of the trials; None for none."""
    return max((cell.key.height_m for cell in experiment.of(strategy) if does_the_job(cell)), default=None)


def _shown(height_m: Optional[float]) -> str:
    return "none" if height_m is None else f"{centimetres(height_m)} cm"


FINDINGS = (combinations_beat_single, soft_hard_fastest, up_to_10_cm, beyond_10_cm)
