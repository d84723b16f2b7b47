"""The verbs of the command line: what each is called with, and what the help says of them."""

import argparse
from dataclasses import dataclass
from typing import Callable, Dict, List, NoReturn, Optional, Tuple

from .failure import EXIT_USAGE, UsageError
from .places import Places
from .running_stack import RunningStack
from .stack_options import add_place_options
from .strict_yaml import did_you_mean

Function = Callable[[argparse.Namespace, Places], int]

_EXIT_CODES = "exit codes: 0 success, 1 failure, 2 bad usage or configuration (nothing was started),\n" \
              "130 interrupted; docs/commands.md has them all."


class Parser(argparse.ArgumentParser):
    """A mistake is one line on stderr and exit code 2, as of every program of the project."""

    def error(self, message: str) -> NoReturn:
        self.exit(EXIT_USAGE, f"{self.prog}: {message} (see --help)\n")


@dataclass(frozen=True)
class Tool:
    """A verb whose words a compiled program reads."""

    program: str
    of_stack: Optional[Callable[[RunningStack], List[str]]]  # what it is told of the one that is up
    read: Optional[Callable[[List[str], Places], List[str]]] = None  # its words, of what a person said
    own: Tuple[str, ...] = ()  # options that the launcher reads for it; each takes a value


class Verbs:
    """Collects them, in groups."""

    def __init__(self) -> None:
        self.parser = Parser(
            prog="scarab", usage="scarab VERB [OPTION...]", allow_abbrev=False,
            formatter_class=argparse.RawDescriptionHelpFormatter)
        self._sub = self.parser.add_subparsers(prog="scarab", metavar="VERB", required=True,
                                               help=argparse.SUPPRESS)
        self.parsers: Dict[str, argparse.ArgumentParser] = {}
        self._of_stack: Dict[str, bool] = {}
        self.tools: Dict[str, Tool] = {}
        self.texts: Dict[str, str] = {}
        self._lines: List[str] = []

    def group(self, title: str) -> None:
        self._lines += ["", f"{title}:"]

    def add(self, name: str, function: Function, text: str, examples: str,
            more: str = "", operands: str = "", of_stack: bool = True) -> argparse.ArgumentParser:
        """A verb of the launcher. `text` is a line of the list; `more` follows it in its own help.
        It takes --domain if it is `of_stack`: about a stack on DDS."""
        self._note(name, text)
        parser = self._sub.add_parser(
            name, usage=f"scarab {name} [OPTION...]{operands}", allow_abbrev=False,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            description=text[0].upper() + text[1:] + "." + (f"\n\n{more}" if more else ""),
            epilog=f"{_examples(examples)}\n\n{_EXIT_CODES}")
        parser.set_defaults(verb=function)
        self.parsers[name] = parser
        self._of_stack[name] = of_stack
        return parser

    def add_tool(self, name: str, program: str, text: str,
                 of_stack: Optional[Callable[[RunningStack], List[str]]] = None,
                 read: Optional[Callable[[List[str], Places], List[str]]] = None,
                 own: Tuple[str, ...] = ()) -> None:
        """A verb that hands on."""
        self._note(name, text)
        self._sub.add_parser(name, add_help=False)
        self.tools[name] = Tool(program, of_stack, read, own)

    def finish(self, examples: str) -> None:
        """After the last one: what all have in common."""
        for name, parser in self.parsers.items():
            add_place_options(parser, self._of_stack[name])
        self.parser.description = "\n".join([
            "Starts, watches and stops the Scarab stack, and runs trials on it.", *self._lines])
        self.parser.epilog = (f"`scarab VERB --help` shows the options of a verb.\n\n"
                              f"{_examples(examples)}\n\n{_EXIT_CODES}")

    def parse(self, words: List[str]) -> argparse.Namespace:
        """Ends with exit code 2 at a word that nobody knows, with what may have been meant."""
        if not words:
            raise UsageError("scarab: no verb was given; see deploy/scarab --help")
        known = [*self.parsers, *self.tools]
        if not words[0].startswith("-") and words[0] not in known:
            raise UsageError(f"scarab: unknown verb '{words[0]}'{did_you_mean(words[0], known)}; "
                             "see deploy/scarab --help")
        options, unknown = self.parser.parse_known_args(words)
        if unknown:
            word = unknown[0].split("=")[0]
            raise UsageError(f"scarab {words[0]}: unknown argument '{unknown[0]}'"
                             f"{did_you_mean(word, options_of(self.parsers[words[0]]))} (see --help)")
        return options

    def _note(self, name: str, text: str) -> None:
        self.texts[name] = text
        self._lines.append(f"  {name:11} {text}")


def options_of(parser: argparse.ArgumentParser) -> Dict[str, argparse.Action]:
    """Every option by its name; argparse itself has no question for them."""
    return {name: action for action in parser._actions
            for name in action.option_strings}


def _examples(lines: str) -> str:
    heading = "examples:" if "\n" in lines else "example:"
    return "\n".join([heading, *(f"  {line}" for line in lines.splitlines())])
