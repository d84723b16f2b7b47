"""`scarab config` for the files that the launcher itself reads: stack.yaml and the experiments."""

import subprocess
import sys
from pathlib import Path
from typing import List, Optional

from .experiments.declaration import experiment_schema
from .experiments.experiment_file import FOLDER, read_experiment
from .failure import EXIT_OK, ConfigError
from .places import Places
from .stack_declaration import stack_schema

_SCHEMAS = {"stack": stack_schema, "experiment": experiment_schema}


def answer_config(words: List[str], places: Places) -> Optional[int]:
    """The exit code, where the words are (also) of such files; None where scarab-config alone knows."""
    if words[:1] == ["schema"] and len(words) == 2 and words[1] in _SCHEMAS:
        print(_SCHEMAS[words[1]](), end="")
        return EXIT_OK
    ours = [word for word in words[1:] if _is_experiment(word)] if words[:1] == ["check"] else []
    if not ours:
        return None
    code = max(_check(Path(word)) for word in ours)
    others = [word for word in words if word not in ours]
    if any(not word.startswith("-") for word in others[1:]):
        sys.stdout.flush()
        command = [str(places.program("scarab-config")), *others]
        code = max(code, subprocess.run(command, check=False).returncode)
    return code


def _is_experiment(word: str) -> bool:
    """By its folder, as scarab-config knows the kinds of its files."""
    return not word.startswith("-") and Path(word).resolve().parent.name == FOLDER.name


def _check(file: Path) -> int:
    try:
        read_experiment(file)
    except ConfigError as error:
        print(error, file=sys.stderr)
        return error.exit_code
    print(f"{file}: ok")
    return EXIT_OK
