"""Keeps a stack: starts its services in order, restarts the crashed, stops them in reverse."""

import signal
import time
from typing import Callable, Dict, List, Optional, Sequence

from .back_off import LOOP_AFTER
from .failure import Failure, Interrupted
from .readiness import ReadinessQuestion
from .restart_rule import must_wait, restart_allowed
from .run_directory import RunDirectory
from .service_child import ServiceChild, how_it_ended
from .signals import Signals
from .stack import ServiceProcess, Stack
from .trial_lock import series_that_runs

Command = List[str]
Report = Callable[[Dict[str, object]], None]
_LOCK_POLL_S = 0.2
_DEVICE_PATIENCE_S = 10.0
_DEVICE_POLL_S = 0.01
_TERM_PATIENCE_S = 5.0


class Keeper:
    """Runs in a process of its own; `report` tells the launcher (and the log) what happens."""

    def __init__(self, stack: Stack, directory: RunDirectory,
                 command_of: Callable[[ServiceProcess], Command], wait_ready: Sequence[str],
                 report: Report, signals: Signals):
        """`wait_ready` is a program that ends with 0 when the whole stack is ready."""
        self._stack = stack
        self._directory = directory
        self._command_of = command_of
        self._wait_ready_command = wait_ready
        self._report = report
        self._signals = signals
        self._children = [ServiceChild(process, directory, stack.back_off)
                          for process in stack.processes()]

    def run(self, when_ready: Callable[[], None]) -> int:
        """Until it is asked to stop. Returns the exit code of the keeper."""
        try:
            self._start_all()
            self._wait_ready()
            when_ready()
            self._report({"event": "ready"})
            self._supervise()
            return 0
        except Interrupted:
            return 0
        except Failure as failure:
            self._report({"event": "failed", "text": str(failure)})
            return failure.exit_code
        finally:
            self._stop_all()

    def _start_all(self) -> None:
        for child in self._children:
            self._signals.raise_if_stop_requested()
            try:
                child.start(self._command_of(child.process))
            except OSError as error:
                raise Failure(f"{child.name} cannot be started: {error.strerror}") from None
            self._report({"event": "started", "service": child.name})
            if child.process.service.hardware:
                self._wait_for_device(child)

    def _wait_for_device(self, hardware: ServiceChild) -> None:
        """The bridge would find it later, too, but only after a complaint and a pause."""
        deadline = time.monotonic() + _DEVICE_PATIENCE_S
        while not self._directory.device.exists():
            self._signals.raise_if_stop_requested()
            self._fail_if_one_ended()
            if time.monotonic() > deadline:
                raise Failure(f"{hardware.name} has made no device within {_DEVICE_PATIENCE_S:g} s; see its log: "
                              f"deploy/scarab logs {hardware.name}")
            self._signals.wait(_DEVICE_POLL_S)

    def _wait_ready(self) -> None:
        began = time.monotonic()
        with ReadinessQuestion(self._wait_ready_command) as question:
            while question.is_open:
                self._signals.raise_if_stop_requested()
                self._fail_if_one_ended()
                for text in question.wait(self._signals, 1.0):
                    self._report({"event": "waiting", "text": text})
            self._signals.raise_if_stop_requested()
            self._fail_if_one_ended()
            if not question.ready:
                raise Failure(f"the stack is not ready after {time.monotonic() - began:.1f} s:\n"
                              f"{question.answer()}")

    def _fail_if_one_ended(self) -> None:
        for child in self._children:
            code = child.take_end()
            if code is not None:
                tail = "\n".join(f"  {line}" for line in child.last_log_lines())
                raise Failure(f"{child.name} {how_it_ended(code)} while the stack was starting; "
                              f"the end of its log:\n{tail or '  (empty)'}")

    def _supervise(self) -> None:
        while not self._signals.stop_requested:
            for child in self._children:
                self._look_after(child)
            self._signals.wait(self._time_to_next_change())

    def _look_after(self, child: ServiceChild) -> None:
        code = child.take_end()
        if code is not None:
            self._note_end(child, code)
        if child.restart_due is not None and self._may_restart_now(child):
            self._restart(child)

    def _note_end(self, child: ServiceChild, code: int) -> None:
        rule, how = child.process.service.restart, how_it_ended(code)
        if not restart_allowed(rule, code):
            self._report({"event": "lost", "service": child.name, "text": how})
            return
        child.ended_in = series_that_runs(self._directory.trial_lock)
        wait_s = child.plan_restart(how)
        self._report({"event": "crashed", "service": child.name, "text": how,
                      "restart": child.back_off.restarts, "wait_s": wait_s,
                      "waits": self._must_wait(child)})
        if child.back_off.in_a_row == LOOP_AFTER:
            self._report({"event": "looping", "service": child.name, "crashes": LOOP_AFTER})

    def _restart(self, child: ServiceChild) -> None:
        try:
            child.start(self._command_of(child.process))
        except (OSError, Failure) as error:  # such as a program that is being rebuilt at this moment
            reason = error.strerror if isinstance(error, OSError) else str(error)
            child.plan_restart(f"cannot be started: {reason}")
            self._report({"event": "unstartable", "service": child.name, "text": reason})
            return
        self._report({"event": "restarted", "service": child.name})

    def _may_restart_now(self, child: ServiceChild) -> bool:
        return (time.monotonic() >= child.restart_due
                and not self._must_wait(child))

    def _must_wait(self, child: ServiceChild) -> bool:
        return must_wait(child.process.service.restart, self._directory.trial_lock, child.ended_in)

    def _time_to_next_change(self) -> Optional[float]:
        """Until the next restart, or until the next crashes are forgotten; None: no time is known."""
        times = []
        for child in self._children:
            if child.restart_due is not None:
                left_s = child.restart_due - time.monotonic()
                times.append(left_s if left_s > 0 else _LOCK_POLL_S)  # it waits for a trial's end
            else:
                times.append(child.forgets_crashes_in())
        return min((t for t in times if t is not None), default=None)

    def _stop_all(self) -> None:
        for child in reversed(self._children):
            child.restart_due = None
            if not child.alive():
                child.take_end()
                continue
            child.signal(signal.SIGTERM)
            if not self._wait_end(child, child.process.service.stop_s):
                self._report({"event": "killed", "service": child.name,
                              "after_s": child.process.service.stop_s})
                child.signal(signal.SIGKILL)
                self._wait_end(child, _TERM_PATIENCE_S)
            code = child.take_end()
            self._report({"event": "stopped", "service": child.name, "code": code})

    def _wait_end(self, child: ServiceChild, timeout_s: float) -> bool:
        deadline = time.monotonic() + timeout_s
        while child.alive():
            left_s = deadline - time.monotonic()
            if left_s <= 0:
                return False
            self._signals.wait(left_s)
        return True
