"""Verbs that hand on to a compiled tool: `topic`, `log`, `config`, `operator`, `drive`."""

import os
import sys
from typing import List, NoReturn, Optional, Sequence

from .places import Places
from .running_stack import RunningStack, choose_stack
from .verbs import Tool

_BUS = ("--domain", "--tag", "--interface", "--peers")


def hand_on(tool: Tool, words: List[str], places: Places) -> NoReturn:
    """Becomes the tool, which is told of the running stack."""
    program = str(places.program(tool.program))
    said = tool.read(words, places) if tool.read else words
    become([program, *said, *told(tool, words, places)])


def told(tool: Tool, words: List[str], places: Places) -> List[str]:
    """What a tool is told of the running stack: of that on the domain the words name, else of the only one.
    Words that say more of the bus than its domain say all of it."""
    if not tool.of_stack or _says(words, "-h", "--help", "--tag", "--interface"):
        return []
    domain = _domain(words)
    stack = choose_stack(places.runs, domain)
    if stack is None:
        return []
    of_stack = tool.of_stack(stack)
    return of_stack if domain is None else _without(of_stack, "--domain")


def bus_words(words: List[str]) -> List[str]:
    """Those of the words that say where on DDS."""
    found = []
    for word, following in zip(words, [*words[1:], ""]):
        if word in _BUS:
            found += [word, following]
        elif word.split("=")[0] in _BUS:
            found.append(word)
    return found


def _domain(words: List[str]) -> Optional[int]:
    for word, following in zip(words, [*words[1:], ""]):
        name, equals, value = word.partition("=")
        number = value if equals else following
        if name == "--domain" and number.isdigit():
            return int(number)
    return None


def _without(words: List[str], option: str) -> List[str]:
    at = words.index(option)
    return words[:at] + words[at + 2:]


def bus_of(stack: RunningStack) -> List[str]:
    return list(stack.bus.arguments())


def become(command: Sequence[str]) -> NoReturn:
    sys.stdout.flush()
    os.execv(command[0], list(command))


def _says(words: List[str], *options: str) -> bool:
    return any(word == option or word.startswith(option + "=")
               for word in words for option in options)
