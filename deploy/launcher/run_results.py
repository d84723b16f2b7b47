"""What a run leaves: a whole log, a figure, and the lines that say where everything is."""

import sys
from pathlib import Path
from typing import Sequence

from .failure import Failure, Interrupted
from .figure import draw_figure, first_trial
from .foreground import run_in_front
from .log_files import closed_name, in_words, is_open, log_files
from .places import Places, shown
from .run_directory import RunDirectory
from .signals import Signals


def mend_log(places: Places, directory: RunDirectory, signals: Signals) -> None:
    """A logger that was killed leaves its file open: what is whole in it becomes the log."""
    for active in log_files(directory.path):
        if not is_open(active):
            continue
        closed = active.with_name(closed_name(active))
        code = run_in_front([places.program("scarab-log"), "recover", active, closed], signals)
        print(f"scarab: the logger did not close {active.name}; scarab-log recover "
              f"{'made ' + closed.name + ' of it' if code == 0 else 'failed'}", file=sys.stderr)


def figure_of(places: Places, directory: RunDirectory, stack_directory: RunDirectory, logger: bool,
              signals: Signals) -> None:
    """Fig. 7 of the first trial. The trials are no failure where it cannot be drawn. `logger`: the stack has one,
    here or elsewhere."""
    logs = log_files(stack_directory.path)
    if not logs:
        why = "the log is where the logger runs" if logger else "without a logger there is no log"
        print(f"scarab: no figure: {why}", file=sys.stderr)
        return
    try:
        draw_figure(places, logs, first_trial(directory.results),
                    directory.path / "figure7", signals)
    except Interrupted:
        raise
    except Failure as failure:
        print(f"scarab: figure 7 could not be drawn: {failure}", file=sys.stderr)


def say_where(directory: RunDirectory, stack_directory: RunDirectory, lacks: Sequence[str] = ()) -> None:
    """`lacks` says what of the samples is not in the log."""
    lines = [("run", _existing(directory.path)),
             ("log", in_words(log_files(stack_directory.path))),
             ("log lacks", "; ".join(lacks)),
             ("results", _existing(directory.results)),
             ("figure", _existing(directory.path / "figure7.svg")),
             ("", _existing(directory.path / "figure7.png")),
             ("configuration", _existing(stack_directory.config))]
    for name, text in lines:
        if text:
            print(f"{name + ':' if name else '':15}{text}")


def _existing(path: Path) -> str:
    return shown(path) if path.exists() else ""
