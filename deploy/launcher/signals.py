"""Signals as something to wait for, instead of exceptions at a random line."""

import os
import selectors
import signal
from typing import Iterable, Optional, Set

from .failure import Interrupted

STOP_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Signals:
    """Collects stop requests and ends of children for the whole process, from `__init__` on.

    A request to stop that comes during the shutdown is noted and changes nothing.
    """

    def __init__(self) -> None:
        self.stop_requested = False
        self._read_end, self._write_end = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)
        signal.set_wakeup_fd(self._write_end, warn_on_full_buffer=False)
        for number in (*STOP_SIGNALS, signal.SIGCHLD):
            if number == signal.SIGHUP and signal.getsignal(number) == signal.SIG_IGN:
                continue  # started by nohup
            signal.signal(number, self._note)

    def wait(self, timeout_s: Optional[float] = None,
             readable: Iterable[int] = ()) -> Set[int]:
        """Returns at a signal, when one of the descriptors is readable, or after the time.

        The result holds the descriptors that are readable.
        """
        with selectors.DefaultSelector() as selector:
            selector.register(self._read_end, selectors.EVENT_READ)
            for descriptor in readable:
                selector.register(descriptor, selectors.EVENT_READ)
            ready = {key.fd for key, _ in selector.select(timeout_s)}
        self._drain()
        return ready - {self._read_end}

    def raise_if_stop_requested(self) -> None:
        if self.stop_requested:
            raise Interrupted()

    def _note(self, number: int, _frame: object) -> None:
        if number in STOP_SIGNALS:
            self.stop_requested = True

    def _drain(self) -> None:
        try:
            while os.read(self._read_end, 512):
                pass
        except BlockingIOError:
            pass
