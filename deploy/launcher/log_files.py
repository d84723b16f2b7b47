"""The log of a run: one file, or several where the logger was restarted, or splits its log."""

import re
from pathlib import Path
from typing import List, Sequence, Tuple

from .places import shown

OPEN = ".active"  # behind the name of a file that its recorder has not closed, or not yet
_FEW = 3


def log_files(directory: Path) -> List[Path]:
    """In the order of writing; those that were not closed too. Of trials on a stack that is (or was) up, the
    stack's."""
    stack = directory / "stack"  # a link that `scarab run` makes
    place = stack if stack.is_symlink() else directory
    found = {path.name.removesuffix(OPEN): path for path in sorted(place.glob("trial*"), reverse=True)
             if is_log(path.name)}  # the closed one, where there are both
    return [found[name] for name in sorted(found, key=_order)]


def is_open(log: Path) -> bool:
    """Its recorder is still at work, or was killed."""
    return log.name.endswith(OPEN)


def closed_name(log: Path) -> str:
    return log.name.removesuffix(OPEN)


def is_log(name: str) -> bool:
    """By the end of its name."""
    return name.removesuffix(OPEN).endswith(".mcap")


def in_words(logs: Sequence[Path]) -> str:
    """On one line, however many there are; empty for none."""
    if len(logs) <= _FEW:
        return ", ".join([*map(shown, logs[:1]), *(log.name for log in logs[1:])])
    return f"{shown(logs[0])} to {logs[-1].name}, {len(logs)} files"


def _order(name: str) -> Tuple[List[int], str]:
    """trial.mcap, trial-2.mcap, trial-10.mcap."""
    return [int(number) for number in re.findall(r"\d+", name)], name
