"""Result lines of the worker protocol, and the table they become."""

import csv
import io
import json
from dataclasses import dataclass
from typing import Dict, Iterable, List, Optional

from .plan import TRIAL_KEYS, PlannedTrial

OUTCOME_KEYS = ("success", "time_s", "reason", "object_travel_m", "object_sideways_m", "trunk_travel_m",
                "heading_rad", "heading_max_rad", "climb_s", "mode1_s", "mode2_s")
COLUMNS = (*TRIAL_KEYS, *OUTCOME_KEYS, "configuration")


class ForeignLine(ValueError):
    """Not the result of the trial that was asked for; the text says why."""


@dataclass(frozen=True)
class Result:
    """A result line as it came."""

    line: str
    trial: PlannedTrial
    success: bool
    time_s: float

    def row(self, configuration: str) -> List[str]:
        """The texts of the line, digit for digit, in the order of COLUMNS."""
        values = json.loads(self.line, parse_float=str, parse_int=str)
        return [*(_text(values[key]) for key in (*TRIAL_KEYS, *OUTCOME_KEYS)), configuration]


def read_result(line: str, planned: Dict[int, PlannedTrial]) -> Result:
    """ForeignLine for anything else than the result of one of these trials."""
    values = _object(line)
    if tuple(values) != (*TRIAL_KEYS, *OUTCOME_KEYS):
        raise ForeignLine("has other keys than a result")
    trial = planned.get(values["index"]) if isinstance(values["index"], int) else None
    if trial is None:
        raise ForeignLine(f"is of trial {values['index']}, which is not in the plan")
    for key in TRIAL_KEYS:
        if values[key] != getattr(trial, key):
            raise ForeignLine(f"is of trial {trial.index}, but with {key} {values[key]}")
    if not isinstance(values["success"], bool) or not isinstance(values["time_s"], (int, float)):
        raise ForeignLine("says neither success nor failure, or no time")
    return Result(line, trial, values["success"], float(values["time_s"]))


def error_of(line: str) -> Optional[str]:
    """What an error line says; None for any other."""
    try:
        values = _object(line)
    except ForeignLine:
        return None
    return str(values["error"]) if "error" in values else None


def is_final_error(line: str) -> bool:
    """The worker takes no trial at all: its error names none."""
    return "index" not in _object(line)


def table(results: Iterable[Result], configuration: str) -> str:
    """results.csv: sorted by index."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for result in sorted(results, key=lambda r: r.trial.index):
        writer.writerow(result.row(configuration))
    return text.getvalue()


def _object(line: str) -> dict:
    try:
        values = json.loads(line)
    except ValueError:
        values = None
    if not isinstance(values, dict):
        raise ForeignLine("is no JSON object")
    return values


def _text(value: object) -> str:
    if isinstance(value, bool):
        return "1" if value else "0"
    return "" if value is None else str(value)
