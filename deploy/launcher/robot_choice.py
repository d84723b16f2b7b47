"""Which robot a stack is for."""

from pathlib import Path
from typing import List, Optional

from .failure import UsageError
from .strict_yaml import did_you_mean

_ROBOTS = Path("config/robot")


def chosen_robot(in_file: str, wanted: Optional[str], root: Path) -> str:
    """The one that was asked for, else that of the file. UsageError for one that nobody has described, naming those
    that there are."""
    if wanted is None:
        return in_file
    known = known_robots(root)
    if wanted not in known:
        raise UsageError(f"unknown robot '{wanted}'{did_you_mean(wanted, known)}; "
                         f"{_ROBOTS} has {', '.join(known) or 'none'}")
    return wanted


def known_robots(root: Path) -> List[str]:
    return sorted(file.stem for file in (root / _ROBOTS).glob("*.yaml"))
