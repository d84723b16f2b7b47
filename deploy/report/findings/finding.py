"""A statement and what the measurement says to it."""

from dataclasses import dataclass, field
from enum import Enum
from typing import Dict, List, Sequence

from ..cells import Cell

HALF = 0.5  # a strategy that does not succeed in at least half of the trials does not do the job


class Verdict(Enum):
    AGREES = "agrees"
    PARTLY = "partly"
    DIFFERS = "does not agree"
    OPEN = "not measured"


class Source(Enum):
    """Who states it."""

    PAPER = "paper"
    AIM = "aim of Scarab"


@dataclass(frozen=True)
class Finding:
    name: str
    statement: str  # in our own words
    verdict: Verdict
    numbers: List[str]  # what the verdict rests on
    reason: str = ""  # where it does not agree: what limits it, as far as the data tell
    source: Source = field(default=Source.PAPER)

    @property
    def word(self) -> str:
        """An aim is met rather than agreed to."""
        if self.source is Source.PAPER:
            return self.verdict.value
        return {Verdict.AGREES: "met", Verdict.PARTLY: "partly met", Verdict.DIFFERS: "not met",
                Verdict.OPEN: "not measured"}[self.verdict]

    def document(self) -> Dict[str, object]:
        """For summary.json."""
        return {"name": self.name, "source": self.source.value, "statement": self.statement,
                "verdict": self.word, "numbers": self.numbers, "reason": self.reason}


def graded(met: Sequence[bool], enough_for_partly: bool = False) -> Verdict:
    """All met: agrees; some, or `enough_for_partly`: partly; nothing to judge: not measured."""
    if not met:
        return Verdict.OPEN
    if all(met):
        return Verdict.AGREES
    return Verdict.PARTLY if any(met) or enough_for_partly else Verdict.DIFFERS


def does_the_job(cell: Cell) -> bool:
    return cell.n > 0 and cell.share >= HALF
