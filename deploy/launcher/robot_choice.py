"""Which robot a stack is for: its name fills in `{robot}` in the paths of stack.yaml."""

from pathlib import Path
from typing import Iterable, List, Optional, Set

from .failure import UsageError
from .stack import Service
from .strict_yaml import Value, did_you_mean

_MARK = "{robot}"
_ROBOTS = Path("config/robot")


class RobotChoice:
    """The robot that was asked for, else that of the file."""

    def __init__(self, in_file: str, wanted: Optional[str], root: Path):
        """UsageError for a robot that nobody has described, naming those that there are."""
        self._root = root
        self._filled_in: Set[Path] = set()
        self.name = in_file
        if wanted is None:
            return
        known = known_robots(root)
        if wanted not in known:
            raise UsageError(f"unknown robot '{wanted}'{did_you_mean(wanted, known)}; "
                             f"{_ROBOTS} has {', '.join(known) or 'none'}")
        self.name = wanted

    def fill_in(self, text: str, place: Value) -> Path:
        """The path, from the root of the source tree. ConfigError where no robot is named."""
        if _MARK not in text:
            return self._root / text
        if not self.name:
            place.fail(f"says {_MARK}, but the file has no key 'robot'")
        filled_in = self._root / text.replace(_MARK, self.name)
        self._filled_in.add(filled_in)
        return filled_in

    def check_files(self, services: Iterable[Service]) -> None:
        """UsageError for the first service that has no file for this robot."""
        for service in services:
            for path in (service.robot, service.config):
                if path in self._filled_in and not path.is_file():
                    raise UsageError(f"robot '{self.name}' has no {path.relative_to(self._root)}, "
                                     f"which service {service.name} reads")


def known_robots(root: Path) -> List[str]:
    return sorted(file.stem for file in (root / _ROBOTS).glob("*.yaml"))
