"""Verbs that hand on to a compiled tool: `topic`, `log`, `config`, `operator`."""

import os
import sys
from typing import List, NoReturn, Sequence

from .places import Places
from .running_stack import choose_stack
from .verbs import Tool

_BUS_OPTIONS = ("--domain", "--tag", "--interface")


def hand_on(tool: Tool, words: List[str], places: Places) -> NoReturn:
    """Becomes the tool, which is told where the running stack is unless the words say so."""
    command = [str(places.program(tool.program)), *words]
    if tool.on_bus and words and not _says(words, "-h", "--help", *_BUS_OPTIONS):
        stack = choose_stack(places.runs, None)
        if stack is not None:
            command += stack.bus.arguments()
    become(command)


def become(command: Sequence[str]) -> NoReturn:
    sys.stdout.flush()
    os.execv(command[0], list(command))


def _says(words: List[str], *options: str) -> bool:
    return any(word == option or word.startswith(option + "=")
               for word in words for option in options)
