"""The options and operands of a program: from an argparse parser, or from the help of a compiled tool."""

import argparse
import re
from dataclasses import dataclass, field
from typing import Dict, List, Optional, Sequence, Tuple

from .verbs import options_of

_LINE = re.compile(r"  (\S.*?)(?:  +(.*))?$")
_CHOICES = re.compile(r"\{([^{}]*)\}")


@dataclass(frozen=True)
class Argument:
    """An option or an operand."""

    name: str                      # as typed, or of the operand
    kind: str = ""                 # what its value is: FILE, DIR, or the name without --
    choices: Tuple[str, ...] = ()
    takes_value: bool = True
    repeatable: bool = False
    note: str = ""


@dataclass(frozen=True)
class Syntax:
    """What a verb, a tool or its subcommand takes."""

    options: Dict[str, Argument]
    operands: List[Argument] = field(default_factory=list)
    commands: Dict[str, str] = field(default_factory=dict)  # subcommands, and what they do
    short: Dict[str, Argument] = field(default_factory=dict)  # options by their short names, such as -n
    faults: Dict[str, str] = field(default_factory=dict)  # words of scarab-emulator, and what they do

    def option(self, word: str) -> Optional[Argument]:
        return self.options.get(word) or self.short.get(word)

    def operands_among(self, words: Sequence[str]) -> List[int]:
        """Where the operands are: neither options nor their values."""
        found, value_follows = [], False
        for index, word in enumerate(words):
            if not value_follows and not word.startswith("-"):
                found.append(index)
            option = None if value_follows else self.option(word)
            value_follows = option is not None and option.takes_value
        return found

    def operand(self, number: int) -> Optional[Argument]:
        """Counted from 0; the last one may come again."""
        return self.operands[min(number, len(self.operands) - 1)] if self.operands else None


def syntax_of_parser(parser: argparse.ArgumentParser) -> Syntax:
    options = {name: _argument(name, action) for name, action in options_of(parser).items()}
    operands = [_argument(action.dest, action)
                for action in parser._get_positional_actions()]  # argparse has no question for them
    return Syntax({name: option for name, option in options.items() if name.startswith("--")}, operands,
                  short={name: option for name, option in options.items() if not name.startswith("--")})


def _argument(name: str, action: argparse.Action) -> Argument:
    kind = action.metavar if action.metavar in ("FILE", "DIR") else action.dest
    return Argument(name, str(kind), tuple(map(str, action.choices or ())), action.nargs != 0,
                    isinstance(action.default, list), action.help or "")


def syntax_of_help(text: str) -> Syntax:
    """Reads the help that CLI11 prints: sections, and in them a line for each option."""
    syntax, section = Syntax({}), ""
    for line in text.splitlines():
        if line and not line.startswith(" "):
            section = line.rstrip(":")
        match = _LINE.match(line)
        if match is None or line.startswith("   "):  # a continued note, an empty line, a heading
            continue
        words, note = match[1], match[2] or ""
        names, _, value = re.sub(r", ", ",", words).partition(" ")
        if section == "Subcommands":
            syntax.commands[names.split(",")[0]] = note
        elif section == "Faults" and note:
            syntax.faults[words.split()[0]] = note
        elif section == "Positionals":
            syntax.operands.append(_from_help(names, value, note))
        elif section == "Options":
            for name in re.sub(r"\{.*", "", names).split(","):  # --no-x{false}
                names_of_length = syntax.options if name.startswith("--") else syntax.short
                names_of_length[name] = _from_help(name, value, note)
    return syntax


def _from_help(name: str, value: str, note: str) -> Argument:
    choices = _CHOICES.search(value)
    kind = "FILE" if "FILE" in value else "DIR" if "DIR" in value else name.lstrip("-")
    return Argument(name, kind, tuple(choices[1].split(",")) if choices else (), bool(value),
                    "..." in value.split(), note)
