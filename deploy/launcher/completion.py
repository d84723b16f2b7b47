"""What can come next on a command line of `scarab`."""

from dataclasses import replace
from typing import Dict, Iterable, List, Sequence

from .completion_logs import LogValues
from .completion_robot import RobotValues
from .completion_topics import TopicValues
from .completion_values import Candidate, Source, Values, said
from .failure import Failure
from .places import Places
from .syntax import Argument, Syntax, syntax_of_parser
from .tool_syntax import tool_syntax
from .tool_verbs import bus_words, told
from .verbs import Verbs


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
            return _within(syntax, before, typed, Values(self._places, before))
        return self._of_tool(verb, before, typed) if verb in self._verbs.tools else []

    def _of_tool(self, verb: str, words: List[str], typed: str) -> List[Candidate]:
        syntax, begin = tool_syntax(self._places.program(self._verbs.tools[verb].program), words)
        command, before = words[begin - 1] if begin else "", words[begin:]
        own = {name: Argument(name, name.lstrip("-")) for name in self._verbs.tools[verb].own}
        syntax = replace(syntax, operands=[_of_kind(o, verb, command) for o in syntax.operands],
                         options={**own, **syntax.options})
        operands = [before[index] for index in syntax.operands_among(before)]
        sources = self._sources(verb, words, operands, syntax)
        return _within(syntax, before, typed, Values(self._places, words, sources))

    def _sources(self, verb: str, words: List[str], operands: List[str], syntax: Syntax) -> Dict[str, Source]:
        first = operands[0] if operands else ""
        if verb == "log":
            return LogValues(self._places, first, said(words, "--topic")).sources()
        if verb == "topic":
            return TopicValues(self._places, [*bus_words(words), *self._told(verb, words)], first).sources()
        if verb in ("emulator", "calibrate"):
            return RobotValues(syntax.faults, operands).sources()
        return {}

    def _told(self, verb: str, words: List[str]) -> List[str]:
        try:
            return told(self._verbs.tools[verb], words, self._places)
        except Failure:  # several stacks run, and the line does not say as yet which one is meant
            return []


def _within(syntax: Syntax, before: List[str], typed: str, values: Values) -> List[Candidate]:
    option, equals, start = typed.partition("=")
    if equals and option in syntax.options:  # --option=VALUE
        found = values.of(syntax.options[option], start)
        return [Candidate(f"{option}={c.text}", c.note) for c in found]
    last = syntax.option(before[-1]) if before else None
    if last is not None and last.takes_value:
        return values.of(last, typed)
    if typed.startswith("-"):
        given = [word.split("=")[0] for word in before]
        return _starting_with(typed, [Candidate(o.name, o.note) for o in syntax.options.values()
                                      if o.repeatable or o.name not in given])
    commands = [Candidate(name, note) for name, note in syntax.commands.items()]
    operand = syntax.operand(len(syntax.operands_among(before)))
    return _starting_with(typed, commands) + (values.of(operand, typed) if operand else [])


def _of_kind(operand: Argument, verb: str, command: str) -> Argument:
    """Of a tool. What it calls a name is of the kind its command says, as in `operator strategy NAME`; those of
    `log` are logs."""
    return replace(operand, kind="log" if verb == "log" else command if operand.kind == "name" else operand.kind)


def _starting_with(typed: str, candidates: Iterable[Candidate]) -> List[Candidate]:
    return [c for c in candidates if c.text.startswith(typed)]
