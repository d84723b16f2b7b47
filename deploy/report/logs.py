"""Samples of the logs that lie in an experiment's directory, by `scarab-log export`."""

import csv
import io
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Optional, Sequence

from .failure import ReportError
from .trial import Conditions

# A log of an older version lacks what came later; its trials had these values.
_LATER = {"friction_scale": 1.0, "object_mass_kg": 0.0, "object_diameter_m": 0.0}
_SAME = ("strategy", "seed", "height_m", *_LATER)


@dataclass(frozen=True)
class Recorded:
    """One trial in one log."""

    file: Path
    trial: int
    same: tuple  # what a trial of the plan is known by


class Logs:
    """Looked for when first asked."""

    def __init__(self, directory: Path, bin: Path):
        self._directory = directory
        self._bin = bin
        self._found: Optional[Dict[tuple, Recorded]] = None
        # What has been read: figures and findings ask for the same.
        self._tables: Dict[tuple, Dict[str, List[str]]] = {}

    def samples(self, trial: Conditions, topic: str, fields: Sequence[str]) -> Dict[str, List[str]]:
        """Columns over samples, not to be changed; `header.sim_time_ns` is one. ReportError where there are none."""
        recorded = self._recorded(trial)
        if recorded is None:
            raise ReportError(f"{self._directory} has no log of {trial.strategy}, seed {trial.seed}, "
                              f"{_shown_height(trial.height_m)}")
        wanted = [word for field in ("header.sim_time_ns", *fields) for word in ("--field", field)]
        key = (recorded, topic, tuple(fields))
        if key not in self._tables:
            self._tables[key] = self._read(recorded.file, topic, "--trial", str(recorded.trial), *wanted)
        return self._tables[key]

    def has(self, trial: Conditions) -> bool:
        return self._recorded(trial) is not None

    def _recorded(self, trial: Conditions) -> Optional[Recorded]:
        if self._found is None:
            self._found = {found.same: found for file in sorted(self._directory.glob("*.mcap"))
                           for found in self._trials_of(file)}
        return self._found.get(tuple(getattr(trial, name) for name in _SAME))

    def _trials_of(self, file: Path) -> List[Recorded]:
        table = self._read(file, "trial")
        count = len(table.get("strategy", []))
        columns = {"height_m": table.get("obstacle_height_m"), **{name: table.get(name) for name in _SAME
                                                                   if name != "height_m"}}
        found = []
        for i in range(count):
            same = tuple(_LATER[name] if columns[name] is None else _value(name, columns[name][i])
                         for name in _SAME)
            found.append(Recorded(file, int(table["header.trial"][i]), same))
        return found

    def _read(self, file: Path, topic: str, *words: str) -> Dict[str, List[str]]:
        program = self._bin / "scarab-log"
        if not os.access(program, os.X_OK):
            raise ReportError(f"{program} is needed to read {file} and is not built; ./deploy/demo builds it")
        done = subprocess.run([program, "export", file, "--format", "csv", "--topic", f"scarab/{topic}",
                               *words], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            lines = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
            raise ReportError(f"{file}: {lines[-1]}")
        rows = list(csv.reader(io.StringIO(done.stdout)))
        if len(rows) < 2:
            raise ReportError(f"{file} has no samples of scarab/{topic}")
        return {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


def _value(name: str, text: str):
    return text if name == "strategy" else int(text) if name == "seed" else float(text)


def _shown_height(height_m: float) -> str:
    return f"obstacle {height_m:g} m" if height_m else "no obstacle"
