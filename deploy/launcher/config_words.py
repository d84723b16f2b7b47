"""`scarab config` for the files that scarab-config does not know: stack.yaml, experiments and searches."""

import subprocess
import sys
from pathlib import Path
from typing import List, Optional

from .experiments.declaration import experiment_schema
from .experiments.experiment_file import FOLDER, read_experiment
from .failure import EXIT_OK, ConfigError
from .places import Places
from .stack_declaration import stack_schema

_SEARCH = "search"  # the folder of the files that scarab-search reads
_SCHEMAS = {"stack": stack_schema, "experiment": experiment_schema}


def answer_config(words: List[str], places: Places) -> Optional[int]:
    """The exit code, where the words are (also) of such files; None where scarab-config alone knows."""
    if words[:1] == ["schema"] and len(words) == 2 and words[1] in _SCHEMAS:
        print(_SCHEMAS[words[1]](), end="")
        return EXIT_OK
    if words[:1] != ["check"]:
        return None
    experiments = [word for word in words[1:] if _is_of(FOLDER.name, word)]
    searches = [word for word in words[1:] if _is_of(_SEARCH, word)]
    if not experiments + searches:
        return None
    codes = [_check(Path(word)) for word in experiments]
    sys.stdout.flush()
    if searches:
        codes.append(_run(places, "scarab-search", ["check", *searches]))
    others = [word for word in words if word not in experiments + searches]
    if any(not word.startswith("-") for word in others[1:]):
        codes.append(_run(places, "scarab-config", others))
    return max(codes)


def _is_of(folder: str, word: str) -> bool:
    """By its folder, as scarab-config knows the kinds of its files."""
    return not word.startswith("-") and Path(word).resolve().parent.name == folder


def _run(places: Places, program: str, words: List[str]) -> int:
    return subprocess.run([str(places.program(program)), *words], check=False).returncode


def _check(file: Path) -> int:
    try:
        read_experiment(file)
    except ConfigError as error:
        print(error, file=sys.stderr)
        return error.exit_code
    print(f"{file}: ok")
    return EXIT_OK
