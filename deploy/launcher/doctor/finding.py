"""What a check says: that all is well, something worth knowing, or what is wrong and what to do."""

import enum
from dataclasses import dataclass


class Level(enum.Enum):
    """Only problems make `doctor` end with 1."""

    OK = "ok"
    NOTE = "note"
    PROBLEM = "problem"


@dataclass(frozen=True)
class Finding:
    """`what` is the case, and what to do about it (`advice`; empty where nothing is to be done)."""

    level: Level
    what: str
    advice: str = ""


def ok(what: str) -> Finding:
    return Finding(Level.OK, what)


def note(what: str, advice: str = "") -> Finding:
    return Finding(Level.NOTE, what, advice)


def problem(what: str, advice: str) -> Finding:
    return Finding(Level.PROBLEM, what, advice)
