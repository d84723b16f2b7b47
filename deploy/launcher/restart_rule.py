"""Whether, and when, a service that ended is started again."""

from pathlib import Path

from .failure import EXIT_USAGE
from .stack import Restart
from .trial_lock import series_that_runs


def restart_allowed(rule: Restart, code: int) -> bool:
    """Not for a service that refuses its configuration: it would refuse it again."""
    return rule is not Restart.NEVER and code != EXIT_USAGE


def must_wait(rule: Restart, trial_lock: Path, series: str) -> bool:
    """Whether the restart has to wait for the end of the series of trials in which the service ended.

    Not for a later one: that has not begun a trial yet, since it waits for this service.
    """
    return rule is Restart.BETWEEN_TRIALS and series != "" and series == series_that_runs(trial_lock)
