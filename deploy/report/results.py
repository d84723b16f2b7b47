"""results.csv: a row for each trial that was run."""

import csv
import math
from pathlib import Path
from typing import Callable, Dict, List, Optional

from .failure import ReportError
from .trial import CONDITIONS, OUTCOME, Conditions, Trial

COLUMNS = (*CONDITIONS, *OUTCOME, "configuration")


def read_results(file: Path) -> List[Trial]:
    """The rows in the order of their index. ReportError where a column is missing or a row is cut."""
    try:
        with open(file, newline="") as source:
            return _read(csv.reader(source), file)
    except OSError as error:
        raise ReportError(f"{file}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise ReportError(f"{file} is no table: {error}") from None


def _read(lines, file: Path) -> List[Trial]:
    head = next(lines, [])
    missing = [name for name in COLUMNS if name not in head]
    if missing:
        raise ReportError(f"{file} has no column {', '.join(missing)}")
    trials: Dict[int, Trial] = {}
    for fields in lines:
        place = f"{file}:{lines.line_num}"
        if len(fields) != len(head):
            raise ReportError(f"{place}: {len(fields)} fields instead of {len(head)}; is the row cut?")
        trial = _trial(dict(zip(head, fields)), place)
        if trial.asked.index in trials:
            raise ReportError(f"{place}: index {trial.asked.index} stands in an earlier row, too")
        trials[trial.asked.index] = trial
    return [trials[index] for index in sorted(trials)]


def _trial(row: Dict[str, str], place: str) -> Trial:
    def value(name: str):
        try:
            return _PARSERS.get(name, _number)(row[name])
        except ValueError:
            raise ReportError(f"{place}: {name}: '{row[name]}' is no value of this column") from None

    return Trial(asked=Conditions(**{name: value(name) for name in CONDITIONS}),
                 **{name: value(name) for name in (*OUTCOME, "configuration")})


def _number(text: str) -> float:
    number = float(text)
    if not math.isfinite(number):
        raise ValueError(text)
    return number


def _optional(text: str) -> Optional[float]:
    return _number(text) if text else None


def _truth(text: str) -> bool:
    if text not in ("0", "1"):
        raise ValueError(text)
    return text == "1"


_PARSERS: Dict[str, Callable] = {
    "index": int, "seed": int, "strategy": str, "goal": str, "reason": str, "configuration": str,
    "perturb_cpg_phase": _truth, "success": _truth,
    "climb_s": _optional, "mode1_s": _optional, "mode2_s": _optional}
