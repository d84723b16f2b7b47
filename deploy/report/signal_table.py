"""The tidy table behind Fig. 7: a row a tick, joined from the samples of two topics."""

import csv
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Sequence

from .failure import ReportError

# Slots of the left legs' joints in position_rad (idl/scarab/header.idl).
JOINT_SLOTS = {"TL0": 0, "TL1": 1, "TL2": 2, "CL0": 6, "CL1": 7, "CL2": 8}
_SIGNALS = ("bs_rad", "bs_threshold_rad", "as_rad", "as_threshold_rad")
_STATES = ("IDLE", "APPROACH", "CLIMB", "MODE_1", "MODE_2", "DONE", "FAILED", "SAFE_STOP",
           "MANUAL")
_MODES = ("STOP", "FORWARD", "BACKWARD", "SOFT_PUSH", "BOXING", "STATIONARY", "HARD_PUSH")
_POSITIONS = {f"{joint}_rad": f"position_rad[{slot}]" for joint, slot in JOINT_SLOTS.items()}
_COLUMNS = ("time_s", "state", "mode", *_SIGNALS, *(f"{joint}_rad" for joint in JOINT_SLOTS))
Row = Dict[str, str]


@dataclass(frozen=True)
class SignalTable:
    """Columns over ticks; angles in rad, times in s since the start of the trial."""

    time_s: List[float]
    state: List[str]
    mode: List[str]
    signals: Dict[str, List[float]]


def join_tables(behaviour: Path, robot_state: Path) -> SignalTable:
    """Joins the samples of both topics by simulated time."""
    decided = _read_rows(behaviour, ["header.sim_time_ns", "state", "mode", *_SIGNALS])
    measured = _read_rows(robot_state, ["header.sim_time_ns", *_POSITIONS.values()])
    return joined(decided, measured, f"{behaviour} and {robot_state}")


def joined(decided: Sequence[Row], measured: Sequence[Row], origin: str) -> SignalTable:
    """Rows of scarab/behaviour with those of scarab/robot_state at the same time. A sample may be there twice: a
    restarted logger is told the newest once more."""
    at_time = {int(row["header.sim_time_ns"]): row for row in measured}
    rows = []
    for time_ns, row in {int(row["header.sim_time_ns"]): row for row in decided}.items():
        if time_ns not in at_time:
            continue
        rows.append({
            "time_s": time_ns * 1e-9,
            "state": _named(row["state"], "BEHAVIOUR_", _STATES),
            "mode": _named(row["mode"], "MODE_", _MODES),
            **{name: row[name] for name in _SIGNALS},
            **{name: at_time[time_ns][column] for name, column in _POSITIONS.items()},
        })
    return _table(rows, f"{origin} have no tick in common")


def read_table(file: Path) -> SignalTable:
    """What write_table wrote."""
    return _table(_read_rows(file, _COLUMNS), f"{file} has no rows")


def write_table(file: Path, table: SignalTable) -> None:
    with open(file, "w", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(_COLUMNS)
        for i, time_s in enumerate(table.time_s):
            numbers = (f"{table.signals[name][i]:.9g}" for name in _COLUMNS[3:])
            writer.writerow([f"{time_s:.9g}", table.state[i], table.mode[i], *numbers])


def _read_rows(file: Path, columns: Sequence[str]) -> List[Dict[str, str]]:
    with open(file, newline="") as source:
        reader = csv.DictReader(source)
        missing = [name for name in columns if name not in (reader.fieldnames or [])]
        if missing:
            raise ReportError(f"{file} has no column {', '.join(missing)}")
        return list(reader)


def _table(rows: List[Dict[str, object]], complaint: str) -> SignalTable:
    if not rows:
        raise ReportError(complaint)
    try:
        rows = sorted(rows, key=lambda row: float(row["time_s"]))
        return SignalTable(
            [float(row["time_s"]) for row in rows], [str(row["state"]) for row in rows],
            [str(row["mode"]) for row in rows],
            {name: [float(row[name]) for row in rows] for name in _COLUMNS[3:]})
    except ValueError as error:
        raise ReportError(f"a value is no number: {error}") from None


def _named(value: str, prefix: str, names: Sequence[str]) -> str:
    """An enumerator without its prefix, whether the table has its name or its number."""
    if value.isdigit() and int(value) < len(names):
        return names[int(value)]
    return value[len(prefix):] if value.startswith(prefix) else value
