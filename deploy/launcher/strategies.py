"""Which strategies a stack's supervisor knows."""

from pathlib import Path
from typing import List, Optional

import yaml

from .failure import UsageError
from .places import Places
from .preflight import ask
from .running_stack import RunningStack
from .stack import Stack
from .strict_yaml import did_you_mean


def strategies_of(stack: Stack, places: Places) -> Optional[List[str]]:
    """Asks the supervisor's program, which alone knows how its file is read. None if it runs elsewhere.

    Failure where the program is not built, UsageError where it refuses the file.
    """
    supervisor = stack.service("supervisor")
    if supervisor is None or supervisor.config is None:
        return None
    return _names(ask(places, supervisor, "--dump-config"))


def strategies_of_running(stack: RunningStack) -> Optional[List[str]]:
    """As the supervisor of a stack that is up has read them. None if it runs elsewhere."""
    resolved: Path = stack.directory.config / "supervisor.yaml"
    return _names(resolved.read_text()) if resolved.is_file() else None


def check_strategy(wanted: Optional[str], known: Optional[List[str]]) -> None:
    """UsageError for one that is not there."""
    if wanted is not None and known is not None and wanted not in known:
        raise UsageError(f"unknown strategy '{wanted}'{did_you_mean(wanted, known)}; "
                         f"one of {', '.join(known)}")


def _names(resolved: str) -> List[str]:
    return [str(name) for name in (yaml.safe_load(resolved) or {}).get("strategies", {})]
