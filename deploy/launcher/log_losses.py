"""What a log lacks, as its recorder says of itself."""

import json
import subprocess
from typing import List

from .places import Places
from .spawn import clean_environment
from .stack import LOGGER, Bus

_PATIENCE_S = 2.0
_MARGIN_S = 3.0
_UNWELL = ("degraded", "fault")


def log_losses(places: Places, bus: Bus, expected: str) -> List[str]:
    """A sentence for each logger that had to drop samples, found the disk full, or misses a topic. To be asked while
    the stack is up; of one that says nothing there is nothing to tell."""
    loggers = [part for part in expected.split(",") if part.partition("=")[0] == LOGGER]
    if not loggers:
        return []
    command = [str(places.program("scarab-status")), *bus.arguments(), "--json", "--wait", loggers[0],
               "--timeout", f"{_PATIENCE_S:g}"]
    try:
        asked = subprocess.run(command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL,
                               timeout=_PATIENCE_S + _MARGIN_S, env=clean_environment(), start_new_session=True)
        services = json.loads(asked.stdout)["services"]
        return [s["message"] for s in services if s["service"] == LOGGER and s["health"] in _UNWELL]
    except (subprocess.TimeoutExpired, ValueError, KeyError):
        return []
