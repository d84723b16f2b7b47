"""`--row FILE:N`: a trial of an experiment's results.csv again, with the same options."""

import argparse
import csv
import sys
from pathlib import Path
from typing import Dict, Optional

from .experiments.configuration import SIMULATED, resolve_configuration
from .failure import UsageError
from .places import Places, shown
from .stack import Stack
from .trial_options import GOALS, PARSERS

# Column -> option. The phase of the CPG is perturbed unless nothing is: it has no option of its own.
_COLUMNS = {"strategy": "strategy", "goal": "goal", "height_m": "height", "distance_m": "distance",
            "time_limit_s": "time_limit", "seed": "seed", "perturb_position_m": "perturb_position",
            "perturb_yaw_rad": "perturb_yaw", "perturb_friction": "perturb_friction",
            "friction_scale": "friction_scale", "object_mass_kg": "object_mass",
            "object_diameter_m": "object_diameter"}
_PHASE = "perturb_cpg_phase"
_PERTURBATION = ("perturb_position", "perturb_yaw", "perturb_friction")


def fill_from_row(options: argparse.Namespace) -> None:
    """Gives each option that was not given the row's value. UsageError for what is no row of results."""
    if options.row is None:
        return
    row = read_row(options.row)
    for column, name in _COLUMNS.items():
        if getattr(options, name) is None:
            setattr(options, name, _value(options.row, row, column))
    if row[_PHASE] == "0":
        if any(float(getattr(options, name)) for name in _PERTURBATION):
            raise UsageError(f"--row {options.row}: {_PHASE} is 0, but not the rest of its perturbation; "
                             "such a trial has no options")
        options.no_perturbation = True


def read_row(place: str) -> Dict[str, str]:
    """Of `FILE:N`: the row whose index is N. UsageError where there is none."""
    name, colon, number = place.rpartition(":")
    if not colon or not name or not number.isdigit():
        raise UsageError(f"--row: '{place}' is not FILE:N, such as runs/experiments/obstacle/results.csv:17")
    try:
        with open(name, newline="") as table:
            rows = list(csv.DictReader(table))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        reason = error.strerror if isinstance(error, OSError) else "is no table"
        raise UsageError(f"--row: {name} cannot be read: {reason}") from None
    row = next((row for row in rows if row.get("index") == str(int(number))), None)
    if row is None:
        raise UsageError(f"--row: {name} has no row with index {int(number)}; it has {len(rows)} rows")
    for column in (*_COLUMNS, _PHASE):
        if not row.get(column):
            raise UsageError(f"--row: {name} has no column '{column}': it is no table of an experiment")
    return row


def note_other_configuration(options: argparse.Namespace, stack: Stack, places: Places) -> None:
    """Says so where the row was run with other files than those of the stack: it may then end otherwise."""
    if options.row is None:
        return
    if stack.service("plant") is None:
        print(f"scarab: the row was run with a simulated plant, which profile '{stack.profile}' does not start here: "
              "it may end otherwise", file=sys.stderr, flush=True)
        return
    then: Optional[str] = read_row(options.row).get("configuration")
    now = resolve_configuration(places, stack)
    if not then or then == now.digest():
        return
    folder = Path(options.row.rpartition(":")[0]).parent / "config"
    others = now.files_that_differ(folder) if folder.is_dir() else []
    where = f" ({', '.join(others)})" if others else ""
    files = [f"--config {name}={shown(folder / name)}.yaml" for name in SIMULATED if f"{name}.yaml" in others]
    hint = f"; then it was {' '.join(files)}" if files else ""
    print(f"scarab: the row was run with configuration {then}, this is {now.digest()}{where}: it may end "
          f"otherwise{hint}", file=sys.stderr, flush=True)


def _value(place: str, row: Dict[str, str], column: str) -> object:
    text = row[column]
    if column == "goal" and text not in GOALS:
        raise UsageError(f"--row {place}: {column} '{text}' is none of {', '.join(GOALS)}")
    try:
        return PARSERS[_COLUMNS[column]](text)
    except argparse.ArgumentTypeError as error:
        raise UsageError(f"--row {place}: {column}: {error}") from None
