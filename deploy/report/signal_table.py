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
_POSITION_SOURCES = tuple(f"position_source[{slot}]" for slot in JOINT_SLOTS.values())
_COLUMNS = ("time_s", "state", "mode", *_SIGNALS, *(f"{joint}_rad" for joint in JOINT_SLOTS))
_TRIGGER_NUMBERS = ("trigger_value", "trigger_threshold")
_ORIGINS = ("trigger", "position_source", "imu_source")
_TRIGGERS = ("NONE", "FRONT_ANGLE", "SUPPLY_CURRENT", "FOOT_FORCE")
_SOURCES = ("ABSENT", "MEASURED", "COMMANDED")
Row = Dict[str, str]


@dataclass(frozen=True)
class SignalTable:
    """Columns over ticks; angles in rad, times in s since the start of the trial."""

    time_s: List[float]
    state: List[str]
    mode: List[str]
    signals: Dict[str, List[float]]
    trigger: str  # what switches to mode 2; its signal is `trigger_value`, in rad, A or N
    position_source: str  # MEASURED, COMMANDED, ABSENT: where the joints' angles come from, or MIXED
    imu_source: str  # the same of the inclination


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
        felt = at_time[time_ns]
        rows.append({
            "time_s": time_ns * 1e-9,
            "state": _named(row["state"], "BEHAVIOUR_", _STATES),
            "mode": _named(row["mode"], "MODE_", _MODES),
            **{name: row[name] for name in _SIGNALS},
            **{name: felt[column] for name, column in _POSITIONS.items()},
            **_trigger_of(row),
            "position_source": _common([_named(felt[name], "SOURCE_", _SOURCES)
                                        for name in _POSITION_SOURCES if name in felt]),
            "imu_source": _common([_named(felt["imu_source"], "SOURCE_", _SOURCES)] if "imu_source" in felt else []),
        })
    return _table(rows, f"{origin} have no tick in common")


def read_table(file: Path) -> SignalTable:
    """What write_table wrote."""
    return _table(_read_rows(file, _COLUMNS), f"{file} has no rows")


def write_table(file: Path, table: SignalTable) -> None:
    with open(file, "w", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow((*_COLUMNS, *_TRIGGER_NUMBERS, *_ORIGINS))
        origins = [getattr(table, name) for name in _ORIGINS]
        for i, time_s in enumerate(table.time_s):
            numbers = (f"{table.signals[name][i]:.9g}" for name in (*_COLUMNS[3:], *_TRIGGER_NUMBERS))
            writer.writerow([f"{time_s:.9g}", table.state[i], table.mode[i], *numbers, *origins])


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
        rows = [{**_trigger_of(row), **row} for row in sorted(rows, key=lambda row: float(row["time_s"]))]
        origins = {name: str(rows[-1].get(name, "MEASURED")) for name in _ORIGINS}
        return SignalTable(
            [float(row["time_s"]) for row in rows], [str(row["state"]) for row in rows],
            [str(row["mode"]) for row in rows],
            {name: [float(row[name]) for row in rows] for name in (*_COLUMNS[3:], *_TRIGGER_NUMBERS)}, **origins)
    except ValueError as error:
        raise ReportError(f"a value is no number: {error}") from None


def _trigger_of(row: Row) -> Row:
    """Logs and tables that do not say were made when AS was the only one."""
    if "trigger" not in row:
        return {"trigger": "FRONT_ANGLE", "trigger_value": row["as_rad"], "trigger_threshold": row["as_threshold_rad"]}
    return {"trigger": _named(row["trigger"], "TRIGGER_", _TRIGGERS),
            **{name: row[name] for name in _TRIGGER_NUMBERS}}


def _common(sources: Sequence[str]) -> str:
    """That of all; older logs do not say, and were of a plant that measures everything."""
    different = set(sources) or {"MEASURED"}
    return different.pop() if len(different) == 1 else "MIXED"


def _named(value: str, prefix: str, names: Sequence[str]) -> str:
    """An enumerator without its prefix, whether the table has its name or its number."""
    if value.isdigit() and int(value) < len(names):
        return names[int(value)]
    return value[len(prefix):] if value.startswith(prefix) else value
