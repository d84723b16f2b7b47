"""A program in front of the launcher: it has the terminal's output, the launcher has Ctrl-C."""

import signal
import subprocess
import sys
from pathlib import Path
from typing import Callable, Optional, Sequence, Union

from .places import shown
from .signals import Signals
from .spawn import Output, spawn

_STOP_PATIENCE_S = 10.0


def run_in_front(command: Sequence[Union[str, Path]], signals: Signals, stdout: Output = None,
                 stderr: Output = None, watch: Optional[Callable[[], bool]] = None) -> int:
    """Returns its return code as subprocess does; Interrupted after ending it on a request to stop.

    `watch` replaces the waiting: it returns False to end the program early.
    """
    sys.stdout.flush()
    process = spawn(command, stdout=stdout, stderr=stderr)
    wait = watch or (lambda: signals.wait() is not None)
    go_on = True
    while go_on and process.poll() is None and not signals.stop_requested:
        go_on = wait()
    _end(process)
    signals.raise_if_stop_requested()
    return process.returncode


def _end(process: subprocess.Popen) -> None:
    if process.poll() is not None:
        return
    process.send_signal(signal.SIGTERM)
    try:
        process.wait(_STOP_PATIENCE_S)
    except subprocess.TimeoutExpired:
        print(f"scarab: {shown(Path(process.args[0]))} did not stop within "
              f"{_STOP_PATIENCE_S:g} s and was killed", file=sys.stderr)
        process.kill()
        process.wait()
