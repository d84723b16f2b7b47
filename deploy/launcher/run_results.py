"""What a run leaves: a whole log, a figure, and the lines that say where everything is."""

import sys
from pathlib import Path

from .failure import Failure, Interrupted
from .figure import draw_figure, first_trial
from .foreground import run_in_front
from .places import Places, shown
from .run_directory import RunDirectory
from .signals import Signals


def _log_of(stack_directory: RunDirectory) -> Path:
    closed = stack_directory.path / "trial.mcap"
    return closed if closed.exists() else closed.with_name("trial.mcap.active")


def mend_log(places: Places, directory: RunDirectory, signals: Signals) -> None:
    """A logger that was killed leaves its file open: what is whole in it becomes the log."""
    closed = directory.path / "trial.mcap"
    active = closed.with_name("trial.mcap.active")
    if active.exists() and not closed.exists():
        code = run_in_front([places.program("scarab-log"), "recover", active, closed], signals)
        print(f"scarab: the logger did not close {active.name}; scarab-log recover "
              f"{'made ' + closed.name + ' of it' if code == 0 else 'failed'}", file=sys.stderr)


def figure_of(places: Places, directory: RunDirectory, stack_directory: RunDirectory,
              signals: Signals) -> None:
    """Fig. 7 of the first trial. The trials are no failure where it cannot be drawn."""
    log = _log_of(stack_directory)
    if not log.exists():
        print("scarab: no figure: the log is where the logger runs", file=sys.stderr)
        return
    try:
        draw_figure(places, log, first_trial(directory.results),
                    directory.path / "figure7", signals)
    except Interrupted:
        raise
    except Failure as failure:
        print(f"scarab: figure 7 could not be drawn: {failure}", file=sys.stderr)


def say_where(directory: RunDirectory, stack_directory: RunDirectory) -> None:
    log = _log_of(stack_directory)
    things = [("run", directory.path), ("log", log), ("results", directory.results),
              ("figure", directory.path / "figure7.svg"), ("", directory.path / "figure7.png"),
              ("configuration", stack_directory.config)]
    for name, path in things:
        if path.exists():
            print(f"{name + ':' if name else '':15}{shown(path)}")
