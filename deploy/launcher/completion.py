"""What can come next on a command line of `scarab`."""

import subprocess
from dataclasses import replace
from typing import Iterable, List, Sequence

from .completion_values import Candidate, Values
from .places import Places
from .spawn import clean_environment
from .syntax import Syntax, syntax_of_help, syntax_of_parser
from .verbs import Verbs

_HELP_PATIENCE_S = 2.0


class Completion:
    """Knows the launcher's verbs from their declaration, and those of the tools from their help."""

    def __init__(self, verbs: Verbs, places: Places):
        self._verbs = verbs
        self._places = places

    def of(self, words: Sequence[str]) -> List[Candidate]:
        """What can stand in place of the last of the words (behind the program's name)."""
        *before, typed = words or [""]
        if not before:
            verbs = [Candidate(name, text) for name, text in self._verbs.texts.items()]
            return _starting_with(typed, [*verbs, Candidate("--help")])
        verb, *before = before
        if verb in self._verbs.parsers:
            syntax = syntax_of_parser(self._verbs.parsers[verb])
        elif verb in self._verbs.tools:
            syntax, before = self._tool_syntax(verb, before)
        else:
            return []
        return self._within(syntax, before, typed)

    def _within(self, syntax: Syntax, before: List[str], typed: str) -> List[Candidate]:
        values = Values(self._places, before)
        option, equals, start = typed.partition("=")
        if equals and option in syntax.options:  # --option=VALUE
            found = values.of(syntax.options[option], start)
            return [Candidate(f"{option}={c.text}", c.note) for c in found]
        last = syntax.options.get(before[-1]) if before else None
        if last is not None and last.takes_value:
            return values.of(last, typed)
        if typed.startswith("-"):
            said = [word.split("=")[0] for word in before]
            return _starting_with(typed, [Candidate(o.name, o.note) for o in syntax.options.values()
                                          if o.repeatable or o.name not in said])
        commands = [Candidate(name, note) for name, note in syntax.commands.items()]
        operand = syntax.operand_after(before)
        return _starting_with(typed, commands) + (values.of(operand, typed) if operand else [])

    def _tool_syntax(self, verb: str, before: List[str]) -> "tuple[Syntax, List[str]]":
        """Of the tool, or of its subcommand where one has been given; and the words that follow it."""
        program = str(self._places.program(self._verbs.tools[verb].program))
        syntax = syntax_of_help(_help([program]))
        for index, word in enumerate(before):
            if word in syntax.commands:
                of_command = syntax_of_help(_help([program, word]))
                operands = [replace(o, kind=word) if o.kind == "name" else o
                            for o in of_command.operands]  # as in `operator strategy NAME`
                return (Syntax({**syntax.options, **of_command.options}, operands),
                        before[index + 1:])
        return syntax, before


def _help(command: List[str]) -> str:
    asked = subprocess.run([*command, "--help"], capture_output=True, text=True, check=False,
                           timeout=_HELP_PATIENCE_S, env=clean_environment())
    return asked.stdout


def _starting_with(typed: str, candidates: Iterable[Candidate]) -> List[Candidate]:
    return [c for c in candidates if c.text.startswith(typed)]
