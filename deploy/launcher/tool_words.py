"""What a person may say to `scarab topic` and `scarab log` beyond what the tools themselves understand."""

import sys
from pathlib import Path
from typing import List, Optional

from .failure import Failure, UsageError
from .log_files import is_log, log_files
from .places import Places, shown
from .tool_syntax import tool_syntax

LATEST = "latest"


def log_words(words: List[str], places: Places) -> List[str]:
    """The words for scarab-log: `latest`, and the directory of a run, stand for the log in it.

    UsageError for a log where a command belongs; Failure where there is no log.
    """
    if words and _looks_like_a_log(words[0]):
        raise UsageError(f"scarab log: {words[0]} is a log, not a command: say what to do with it, such as "
                         f"deploy/scarab log info {words[0]}")
    if not any(_directory_of(word, places) for word in words[1:]):
        return words
    syntax, begin = tool_syntax(places.program("scarab-log"), words)
    said = list(words)
    for index in syntax.operands_among(words[begin:]) if begin else ():
        said[begin + index] = log_meant(words[begin + index], places, tell=True)
    return said


def log_meant(word: str, places: Places, tell: bool = False) -> str:
    """The path of the log that a word stands for: of the newest file, where there are several. `tell` says on stderr
    which one that is. Failure where there is none."""
    directory = _directory_of(word, places)
    if directory is None:
        return word
    files = log_files(directory)
    if not files:
        raise Failure(f"there is no log in {shown(directory)}")
    if tell:
        others = f", the last of its {len(files)} files" if len(files) > 1 else ""
        print(f"scarab: {shown(files[-1])}{others}", file=sys.stderr, flush=True)
    return shown(files[-1])


def topic_words(words: List[str], places: Places) -> List[str]:
    """The words for scarab-topic. UsageError for a topic where a command belongs."""
    if words and "/" in words[0]:
        raise UsageError(f"scarab topic: {words[0]} is a topic, not a command: say what to do with it, such as "
                         f"deploy/scarab topic echo {words[0]}")
    return words


def _looks_like_a_log(word: str) -> bool:
    return word == LATEST or is_log(word)


def _directory_of(word: str, places: Places) -> Optional[Path]:
    """The one whose log the word stands for; None for any other word."""
    if word == LATEST and not Path(word).exists():
        return (places.runs / LATEST).resolve()
    return Path(word).resolve() if not word.startswith("-") and Path(word).is_dir() else None
