"""Exact tests for small samples: how often chance alone would show as much."""

import math
from typing import Dict, Sequence


def rank_sum_p(lower: Sequence[float], higher: Sequence[float]) -> float:
    """One-sided p of the rank sum test (Wilcoxon, Mann and Whitney) that `lower` tends to be smaller.

    Exact, by counting all ways to choose the ranks; ties have middle ranks.
    """
    if not lower or not higher:
        return 1.0
    values = sorted([*lower, *higher])
    # Twice the middle rank of each value: a whole number.
    doubled = [values.index(value) + 1 + len(values) - values[::-1].index(value) for value in values]
    of = dict(zip(values, doubled))
    observed = sum(of[value] for value in lower)
    ways = _sums_of_subsets(doubled, len(lower))
    return sum(count for total, count in ways.items() if total <= observed) / sum(ways.values())


def _sums_of_subsets(ranks: Sequence[int], size: int) -> Dict[int, int]:
    """How many subsets of `size` ranks have which sum."""
    by_size = [{0: 1}] + [{} for _ in range(size)]
    for rank in ranks:
        for taken in range(size, 0, -1):
            for total, count in by_size[taken - 1].items():
                by_size[taken][total + rank] = by_size[taken].get(total + rank, 0) + count
    return by_size[size]


def sign_p(better: int, worse: int) -> float:
    """One-sided p of the sign test: of pairs that differ, `better` or more by chance."""
    n = better + worse
    return sum(math.comb(n, k) for k in range(better, n + 1)) / 2**n


def shown_p(p: float) -> str:
    return "p < 0.001" if p < 0.001 else f"p = {p:.3f}" if p < 0.1 else f"p = {p:.2f}"
