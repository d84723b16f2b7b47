"""Whether, and when, a service that ended is started again."""

from pathlib import Path

from .failure import EXIT_USAGE
from .stack import Restart
from .trial_lock import trial_is_running


def restart_allowed(rule: Restart, code: int) -> bool:
    """Not for a service that refuses its configuration: it would refuse it again."""
    return rule is not Restart.NEVER and code != EXIT_USAGE


def must_wait(rule: Restart, trial_lock: Path) -> bool:
    """Whether the restart has to wait for the end of the trials that run on the stack."""
    return rule is Restart.BETWEEN_TRIALS and trial_is_running(trial_lock)
