"""The paths of stack.yaml, in which `{robot}` and `{driver}` stand for what was chosen."""

import re
from pathlib import Path
from typing import Dict, Iterable, Set

from .failure import UsageError
from .stack import Service
from .strict_yaml import Value

_MARK = re.compile(r"\{(\w+)\}")


class MarkedPaths:
    """`names`: by mark (robot, driver), empty where neither the file nor a person says one."""

    def __init__(self, root: Path, names: Dict[str, str]):
        self._root = root
        self._names = names
        self._marks_of: Dict[Path, Set[str]] = {}

    def fill_in(self, text: str, place: Value) -> Path:
        """The path, from the root of the source tree. ConfigError for a mark that stands for nothing."""
        marks = set(_MARK.findall(text)) & set(self._names)
        for mark in marks:
            if not self._names[mark]:
                place.fail(f"says {{{mark}}}, but the file has no key '{mark}'")
            text = text.replace(f"{{{mark}}}", self._names[mark])
        self._marks_of[self._root / text] = marks
        return self._root / text

    def depend_on(self, mark: str, services: Iterable[Service]) -> bool:
        """Whether a service reads a file that the mark chooses."""
        return any(mark in self._marks_of.get(path, ())
                   for service in services for path in service.files().values())

    def check_files(self, services: Iterable[Service]) -> None:
        """UsageError for the first service that has no file for what was chosen."""
        for service in services:
            for path in service.files().values():
                marks = self._marks_of.get(path)
                if marks and not path.is_file():
                    chosen = ", ".join(f"{mark} '{self._names[mark]}'" for mark in sorted(marks, reverse=True))
                    inside = path.relative_to(self._root) if path.is_relative_to(self._root) else path
                    raise UsageError(f"{chosen} has no {inside}, which service {service.name} reads")
