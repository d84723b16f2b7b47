"""What a person may say to `scarab topic`, `log` and `emulator` beyond what the tools themselves understand."""

import sys
from pathlib import Path
from typing import List

from .failure import Failure, UsageError
from .log_files import in_words, is_log, log_files
from .places import Places, shown
from .run_directory import RunDirectory
from .syntax import Argument
from .tool_syntax import tool_syntax

LATEST = "latest"


def log_words(words: List[str], places: Places) -> List[str]:
    """The words for scarab-log: `latest`, and the directory of a run, stand for the log in it.

    UsageError for a log where a command belongs; Failure where there is no log.
    """
    if words and _looks_like_a_log(words[0]):
        raise UsageError(f"scarab log: {words[0]} is a log, not a command: say what to do with it, such as "
                         f"deploy/scarab log info {words[0]}")
    if words and RunDirectory(places.runs / LATEST).log_of(words[0]).is_file():
        raise UsageError(f"scarab log: reads what was recorded; what {words[0]} wrote shows "
                         f"deploy/scarab logs {words[0]}")
    if not any(logs_meant(word, places) for word in words[1:]):
        return words
    syntax, begin = tool_syntax(places.program("scarab-log"), words)
    if not begin:
        return words
    said, operands = words[:begin], syntax.operands_among(words[begin:])
    for index, word in enumerate(words[begin:]):
        operand = syntax.operand(operands.index(index)) if index in operands else None
        said += _logs_of(operand, word, places) if operand else [word]
    return said


def _logs_of(operand: Argument, word: str, places: Places) -> List[str]:
    """All the files of a log, or their directory where the operand is one word; says on stderr which they are."""
    files = logs_meant(word, places)
    if not files:
        return [word]
    print(f"scarab: {in_words(files)}", file=sys.stderr, flush=True)
    if operand.repeatable or len(files) == 1:
        return list(map(shown, files))
    return [shown(files[0].parent)]


def logs_meant(word: str, places: Places) -> List[Path]:
    """The files that a word stands for which is the directory of a run, or `latest`; none for any other word. Failure
    where the newest run has no log."""
    if word == LATEST and not Path(word).exists():
        newest = (places.runs / LATEST).resolve()
        files = log_files(newest)
        if not files:
            raise Failure(f"there is no log in {shown(newest)}")
        return files
    return log_files(Path(word).resolve()) if not word.startswith("-") and Path(word).is_dir() else []


def topic_words(words: List[str], places: Places) -> List[str]:
    """The words for scarab-topic. UsageError for a topic where a command belongs."""
    if words and "/" in words[0]:
        raise UsageError(f"scarab topic: {words[0]} is a topic, not a command: say what to do with it, such as "
                         f"deploy/scarab topic echo {words[0]}")
    return words


def emulator_words(words: List[str], places: Places) -> List[str]:
    """The words for scarab-emulator: to `tell`, `latest` stands for the stack of the newest run."""
    if words[:1] != ["tell"] or words[1:2] != [LATEST] or Path(LATEST).exists():
        return words
    newest = (places.runs / LATEST).resolve()
    stack = newest / "stack"  # a link where the run's trials are on a stack that is up
    return ["tell", str(stack.resolve() if stack.is_symlink() else newest), *words[2:]]


def _looks_like_a_log(word: str) -> bool:
    return word == LATEST or is_log(word)
