"""What came of an experiment, as a small table for the screen."""

from typing import Callable, Dict, List, Sequence, Tuple

from .plan import Plan, PlannedTrial, Section
from .results import Result

Rows = List[List[str]]
_UNITS = {"height_m": "height m", "distance_m": "distance m", "object_mass_kg": "mass kg",
          "object_diameter_m": "diameter m", "time_limit_s": "limit s", "friction_scale": "friction"}


def outcome_tables(plan: Plan, results: Sequence[Result]) -> str:
    """A table for each grid: how many trials of a cell succeeded, and how long those took on average."""
    by_index = {result.trial.index: result for result in results}
    return "\n\n".join(_table(section, by_index) for section in plan.sections)


def _table(section: Section, by_index: Dict[int, Result]) -> str:
    if len(section.varied) < 2:
        return _list(section, by_index)
    *of_rows, of_columns = section.varied
    return "\n".join([_matrix(section, by_index, of_rows, of_columns, "succeeded", _successes), "",
                      _matrix(section, by_index, of_rows, of_columns, "mean time s", _mean_time)])


def _list(section: Section, by_index: Dict[int, Result]) -> str:
    keys = list(section.varied) or ["strategy"]
    rows = [[*map(_name, keys), "succeeded", "mean time s"]]
    for values, trials in _groups(section, keys).items():
        done = [by_index[t.index] for t in trials if t.index in by_index]
        rows.append([*map(_shown, values), _successes(done), _mean_time(done)])
    return _aligned(rows)


def _matrix(section: Section, by_index: Dict[int, Result], of_rows: Sequence[str], of_columns: str,
            title: str, said: Callable[[List[Result]], str]) -> str:
    groups = _groups(section, [*of_rows, of_columns])
    columns = list(dict.fromkeys(values[-1] for values in groups))
    rows = [[f"{title}: {', '.join(map(_name, of_rows))} \\ {_name(of_columns)}", *map(_shown, columns)]]
    for start in dict.fromkeys(values[:-1] for values in groups):
        cells = [groups.get((*start, column), []) for column in columns]
        rows.append([" ".join(map(_shown, start)),
                     *(said([by_index[t.index] for t in cell if t.index in by_index]) for cell in cells)])
    return _aligned(rows)


def _groups(section: Section, keys: Sequence[str]) -> Dict[Tuple, List[PlannedTrial]]:
    groups: Dict[Tuple, List[PlannedTrial]] = {}
    for trial in section.trials:
        groups.setdefault(tuple(getattr(trial, key) for key in keys), []).append(trial)
    return groups


def _successes(results: List[Result]) -> str:
    return f"{sum(r.success for r in results)}/{len(results)}" if results else "-"


def _mean_time(results: List[Result]) -> str:
    times = [r.time_s for r in results if r.success]
    return f"{sum(times) / len(times):.1f}" if times else "-"


def _name(key: str) -> str:
    return _UNITS.get(key, key)


def _shown(value: object) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def _aligned(rows: Rows) -> str:
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join("  ".join([row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width
                                                          in zip(row[1:], widths[1:]))]).rstrip()
                     for row in rows)
