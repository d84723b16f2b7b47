"""The values that an option or an operand can take on the command line of `scarab`."""

import os
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Callable, Dict, Iterable, List, Mapping, Sequence

from .driver_choice import known_drivers
from .experiments.experiment_file import EXPERIMENT_WORDS, known_experiments
from .places import Places
from .robot_choice import known_robots
from .run_directory import RunDirectory
from .running_stack import choose_stack, running_stacks
from .stack import Service
from .stack_changes import StackChanges
from .stack_file import read_profiles, read_stack
from .stack_options import DEFAULT_PROFILE
from .strategies import strategies_of, strategies_of_running
from .syntax import Argument

Source = Callable[[str], Iterable[str]]  # from what has been typed so far to values that may begin so


@dataclass(frozen=True)
class Candidate:
    """A word, and what a person might want to know of it."""

    text: str
    note: str = ""


class Values:
    """Of one line: `words` are those already typed, and may say which robot or domain is meant; `own` are the
    sources that its verb has for some kinds."""

    def __init__(self, places: Places, words: Sequence[str], own: Mapping[str, Source] = MappingProxyType({})):
        self._places = places
        self._words = words
        self._sources: Dict[str, Source] = {
            "strategy": lambda _: self._strategies(),
            "robot": lambda _: known_robots(places.root),
            "driver": lambda _: self._drivers(),
            "device": lambda start: paths(start or "/dev/", True),
            "profile": lambda _: read_profiles(places.stack_file),
            "replicas": lambda _: [f"{s.name}=" for s in self._services()],
            "config": self._service_files,
            "interface": lambda _: os.listdir("/sys/class/net"),
            "domain": lambda _: [str(s.bus.domain) for s in running_stacks(places.runs)],
            "service": lambda _: self._logs(),
            "kind": lambda _: [f.stem for f in (places.root / "config" / "schema").glob("*.json")],
            "experiment": lambda _: [*known_experiments(self._places.root), *EXPERIMENT_WORDS],
            "FILE": lambda start: paths(start, True),
            "file": lambda start: paths(start, True),
            "DIR": lambda start: paths(start, False),
            **own,
        }

    def of(self, argument: Argument, start: str) -> List[Candidate]:
        """Those that begin with what has been typed so far."""
        if argument.choices:
            found: Iterable[str] = argument.choices
        else:
            found = self._sources.get(argument.kind, lambda _: [])(start)
        return [Candidate(text) for text in sorted(found) if text.startswith(start)]

    def _strategies(self) -> List[str]:
        stack = choose_stack(self._places.runs, None)
        known = strategies_of_running(stack) if stack and not self._said("--robot") else None
        if known is None:
            changes = StackChanges(robot=self._said("--robot") or None)
            known = strategies_of(self._stack(changes), self._places)
        return known or []

    def _services(self) -> Sequence[Service]:
        return self._stack(StackChanges(emulated="--emulated" in self._words)).services

    def _drivers(self) -> List[str]:
        robot = self._said("--robot") or read_stack(self._places.stack_file, DEFAULT_PROFILE, self._places.root).robot
        return known_drivers(self._places.root, robot)

    def _stack(self, changes: StackChanges):
        profile = self._said("--profile") or DEFAULT_PROFILE
        return read_stack(self._places.stack_file, profile, self._places.root, changes)

    def _service_files(self, start: str) -> List[str]:
        name, equals, file = start.partition("=")
        if not equals:
            return [f"{s.name}=" for s in self._services() if s.config or s.plant]
        return [f"{name}={path}" for path in paths(file, True)]

    def _logs(self) -> List[str]:
        stack = choose_stack(self._places.runs, None)
        directory = stack.directory if stack else RunDirectory(self._places.runs / "latest")
        return [file.stem for file in directory.logs.glob("*.log")]

    def _said(self, option: str) -> str:
        return said(self._words, option)


def said(words: Sequence[str], option: str) -> str:
    """The value of an option that has been typed already; empty without it."""
    for word, following in zip(words, [*words[1:], ""]):
        if word == option:
            return following
        if word.startswith(option + "="):
            return word.partition("=")[2]
    return ""


def paths(start: str, files: bool) -> List[str]:
    """Files and folders that begin so; folders end in a slash."""
    name = start.rpartition("/")[2]
    shown = start[:len(start) - len(name)]
    place = Path(os.path.expanduser(shown or "."))
    try:
        entries = [e for e in os.scandir(place) if name.startswith(".") or not e.name.startswith(".")]
    except OSError:
        return []
    return [shown + e.name + ("/" if e.is_dir() else "") for e in entries if files or e.is_dir()]
