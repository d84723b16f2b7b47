"""What a compiled tool takes, as its own help says."""

import subprocess
from pathlib import Path
from typing import List, Sequence, Tuple

from .failure import Failure
from .spawn import clean_environment
from .syntax import Syntax, syntax_of_help

_PATIENCE_S = 2.0


def tool_syntax(program: Path, words: Sequence[str]) -> Tuple[Syntax, int]:
    """Of the tool, or of its subcommand where one is among the words; and where the words that follow it begin
    (0: there is none)."""
    syntax = _of([str(program)])
    at = next((i for i, word in enumerate(words) if word in syntax.commands), None)
    if at is None:
        return syntax, 0
    of_command = _of([str(program), words[at]])
    return Syntax({**syntax.options, **of_command.options}, of_command.operands,
                  short={**syntax.short, **of_command.short}, faults=of_command.faults), at + 1


def _of(command: List[str]) -> Syntax:
    try:
        asked = subprocess.run([*command, "--help"], capture_output=True, text=True, check=False,
                               timeout=_PATIENCE_S, env=clean_environment())
    except subprocess.TimeoutExpired:
        raise Failure(f"{command[0]} --help did not answer within {_PATIENCE_S:g} s") from None
    return syntax_of_help(asked.stdout)
