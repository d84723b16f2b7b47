"""plan.json: what was asked of an experiment."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List

from .failure import ReportError
from .trial import CONDITIONS, Conditions

KINDS = ("cpg", "psn", "vrn", "transport_speed", "obstacle", "sequence", "walking", "beyond", "robustness")


@dataclass(frozen=True)
class Plan:
    """README.md of this folder says what its keys mean."""

    name: str
    title: str
    figure: str
    paper_figure: str
    paper: List[str]
    notes: List[str]
    command: str
    version: str
    configuration: str
    trials: List[Conditions]
    robot: str = ""
    shard: str = ""  # such as 1/4; empty: the whole experiment
    wall_s: float = 0.0  # that all sessions took; 0: not known
    simulated_s: float = 0.0


def read_plan(file: Path) -> Plan:
    """ReportError where a key is missing or of another type."""
    try:
        document = json.loads(file.read_text())
    except OSError as error:
        raise ReportError(f"{file}: {error.strerror}") from None
    except ValueError as error:
        raise ReportError(f"{file} is not JSON: {error}") from None
    if not isinstance(document, dict):
        raise ReportError(f"{file} is no JSON object")
    texts = {key: _text(document, key, file)
             for key in ("name", "title", "figure", "command", "version", "configuration")}
    if texts["figure"] not in KINDS:
        raise ReportError(f"{file}: figure: '{texts['figure']}' is none of {', '.join(KINDS)}")
    trials = document.get("trials")
    if not isinstance(trials, list) or not trials:
        raise ReportError(f"{file}: trials: expected the list of planned trials")
    return Plan(
        **texts, paper_figure=str(document.get("paper_figure") or ""), paper=_paragraphs(document.get("paper")),
        notes=_paragraphs(document.get("notes")), robot=str(document.get("robot") or ""),
        shard=str(document.get("shard") or ""),
        trials=[_conditions(trial, f"{file}: trials[{i}]") for i, trial in enumerate(trials)],
        wall_s=_total(document, "wall_s"), simulated_s=_total(document, "simulated_s"))


def _total(document: Dict[str, Any], key: str) -> float:
    """Over all sessions; 0 where they are not told."""
    values = [session.get(key) for session in document.get("sessions") or [] if isinstance(session, dict)]
    return float(sum(value for value in values if isinstance(value, (int, float))))


def _text(document: Dict[str, Any], key: str, file: Path) -> str:
    if not isinstance(document.get(key), str):
        raise ReportError(f"{file}: {key}: expected a text")
    return document[key]


def _paragraphs(value: Any) -> List[str]:
    values = value if isinstance(value, list) else [value]
    return [" ".join(str(text).split()) for text in values if text]


def _conditions(trial: Any, place: str) -> Conditions:
    missing = [key for key in CONDITIONS if not isinstance(trial, dict) or key not in trial]
    if missing:
        raise ReportError(f"{place}: has no {', '.join(missing)}")
    try:
        return Conditions(**{key: Conditions.__annotations__[key](trial[key]) for key in CONDITIONS})
    except (TypeError, ValueError) as error:
        raise ReportError(f"{place}: {error}") from None
