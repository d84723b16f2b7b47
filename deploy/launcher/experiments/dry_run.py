"""`--dry-run`: how large an experiment is, without running it."""

from typing import List

from .plan import Plan, PlannedTrial, Shard


def plan_text(plan: Plan, shard: Shard) -> str:
    """Its cells with the indices of their trials, a line each."""
    experiment, trials = plan.experiment, plan.of_shard(shard)
    cells = len(plan.trials) // plan.trials_per_cell
    share = f", of which shard {shard} has {len(trials)}" if not shard.whole else ""
    lines = [f"{experiment.name}: {experiment.title}",
             f"{cells} cells x {plan.trials_per_cell} trials = {len(plan.trials)} trials{share}",
             f"seeds {plan.first_seed} to {plan.first_seed + plan.trials_per_cell - 1} in every cell, "
             f"{'recorded' if experiment.record else 'not recorded'}, at most "
             f"{sum(trial.time_limit_s for trial in trials):.0f} s of simulated time",
             "", "    index  cell"]
    for section in plan.sections:
        for at in range(0, len(section.trials), plan.trials_per_cell):
            lines.append(_cell_line(section.trials[at], plan.trials_per_cell, section.varied))
    return "\n".join(lines)


def _cell_line(first: PlannedTrial, count: int, varied: "tuple[str, ...]") -> str:
    keys: List[str] = list(varied) or ["strategy"]
    words = [f"{key} {value:g}" if isinstance(value := getattr(first, key), float) else str(value)
             for key in keys]
    indices = f"{first.index}-{first.index + count - 1}" if count > 1 else str(first.index)
    return f"{indices:>9}  {', '.join(words)}"
