"""Verbs that hand on to a compiled tool: `topic`, `log`, `operator`, `sim`."""

import os
import sys
from typing import List, NoReturn

from .failure import UsageError
from .places import Places, shown
from .run_directory import create_run_directory
from .running_stack import choose_stack
from .stack import Stack
from .stack_file import read_stack

_BUS_OPTIONS = ("--domain", "--tag", "--interface")
_SIMULATED = ("plant", "premotor", "supervisor")


def hand_on(program: str, words: List[str], places: Places, needs_bus: bool) -> NoReturn:
    """Becomes the tool, which is told where the running stack is unless the words say so."""
    command = [str(places.program(program)), *words]
    if needs_bus and words and not _asks_help(words) and not _has_option(words, *_BUS_OPTIONS):
        stack = choose_stack(places.runs, None)
        if stack is not None:
            command += stack.bus.arguments()
    _become(command)


def simulate(words: List[str], places: Places) -> NoReturn:
    """The same cores in one process, with the configuration of the stack's profile `sim`."""
    stack = read_stack(places.stack_file, "sim", places.root)
    command = [str(places.program("scarab-sim")), *_configuration(stack), *words]
    if not _asks_help(words) and not _has_option(words, "--output"):
        directory = create_run_directory(places.runs)
        command += ["--output", str(directory.path / "trial.mcap")]
        print(f"run: {shown(directory.path)}")
    _become(command)


def _configuration(stack: Stack) -> List[str]:
    arguments: List[str] = []
    for name in _SIMULATED:
        service = stack.service(name)
        if service is None or service.config is None:
            raise UsageError(f"{stack.file}: `scarab sim` needs the config of service '{name}'")
        arguments += [f"--{name}", str(service.config)]
        if service.robot and "--robot" not in arguments:
            arguments += ["--robot", str(service.robot)]
    return arguments


def _become(command: List[str]) -> NoReturn:
    sys.stdout.flush()
    os.execv(command[0], command)


def _asks_help(words: List[str]) -> bool:
    return _has_option(words, "-h", "--help")


def _has_option(words: List[str], *options: str) -> bool:
    return any(word == option or word.startswith(option + "=")
               for word in words for option in options)
