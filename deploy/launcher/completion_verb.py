"""`scarab completion`: the script of a shell, and the answers to its questions."""

import argparse
import shlex
from typing import List, Sequence

from .completion import Completion
from .failure import EXIT_OK, Failure
from .places import Places
from .verbs import Verbs

ASK = "__complete"  # the scripts' question: `scarab __complete line TEXT` or `... words WORD...`
_SHELLS = ("bash", "zsh")
_MORE = """Verbs, options and their values, of the compiled tools too. For every new shell, add the example's line
to ~/.bashrc or ~/.zshrc, with the whole path."""
_EXAMPLES = """source <(deploy/scarab completion bash)
source <(deploy/scarab completion zsh)"""


def add_verb(verbs: Verbs) -> None:
    parser = verbs.add("completion", completion, "print the completion script of a shell",
                       _EXAMPLES, _MORE, operands=" SHELL", of_stack=False)
    parser.add_argument("shell", metavar="SHELL", choices=_SHELLS, help="bash or zsh")


def completion(options: argparse.Namespace, places: Places) -> int:
    script = places.root / "deploy" / "completion" / f"scarab.{options.shell}"
    print(script.read_text(), end="")
    return EXIT_OK


def answer(words: Sequence[str], verbs: Verbs, places: Places) -> int:
    """Prints what can stand in place of the last word: a candidate a line, and behind a tab what it is.

    A failure means that there is nothing to say: nobody wants an error amid the line being typed.
    """
    try:
        typed = _split(words[1]) if words[0] == "line" else list(words[1:])
        for candidate in Completion(verbs, places).of(typed):
            print(f"{candidate.text}\t{candidate.note}" if candidate.note else candidate.text)
    except (Failure, OSError):
        pass
    return EXIT_OK


def _split(line: str) -> List[str]:
    """The words behind the program's name; the last one is the one being typed, maybe empty."""
    for end in ("", "'", '"'):  # a quote may still be open
        try:
            words = shlex.split(line + end)
        except ValueError:
            continue
        if line[-1:].isspace() and not end:
            words.append("")
        return words[1:]
    return []
