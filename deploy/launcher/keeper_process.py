"""The keeper as a process of its own, and the launcher's end of the line to it."""

import json
import os
import signal
import sys
import time
import traceback
from contextlib import suppress
from pathlib import Path
from typing import Callable, Iterable, Iterator, List, Optional

from .domain_claim import DomainClaim
from .failure import Failure
from .keeper_events import Event
from .process_identity import ProcessIdentity
from .run_directory import RunDirectory
from .signals import STOP_SIGNALS, Signals
from .spawn import die_with_parent

Report = Callable[[Event], None]


class KeeperLine:
    """The launcher's side: events of the keeper, and its end."""

    def __init__(self, pid: int, read_end: int, patience_s: float):
        self._pid = pid
        self._read_end = read_end
        self._identity = ProcessIdentity.of(pid)
        self._patience_s = patience_s
        self._buffer = b""
        self._ended = False
        os.set_blocking(read_end, False)

    def events(self, signals: Signals, timeout_s: Optional[float] = None) -> List[Event]:
        """Waits for a signal, an event, or the time; then what the keeper has said so far."""
        readable = [] if self._ended else [self._read_end]
        signals.wait(timeout_s, readable)
        return self.new_events()

    def new_events(self) -> List[Event]:
        """What the keeper has said so far, without waiting."""
        return list(self._take())

    @property
    def descriptor(self) -> int:
        """Readable when the keeper has said something, or is gone."""
        return self._read_end

    @property
    def ended(self) -> bool:
        """The keeper is gone (it has closed its end of the line)."""
        return self._ended

    def let_go(self) -> None:
        """The keeper stays behind when the launcher ends."""
        os.close(self._read_end)

    def ask_to_stop(self) -> None:
        """Without waiting; to be followed by stop()."""
        self._signal(signal.SIGTERM)

    def stop(self, signals: Signals) -> List[Event]:
        """Asks it to stop the stack and waits until it has. Returns its last events."""
        events: List[Event] = []
        deadline = time.monotonic() + self._patience_s
        self.ask_to_stop()
        while not self._ended and time.monotonic() < deadline:
            events += self.events(signals, deadline - time.monotonic())
        if not self._ended:
            self._signal(signal.SIGKILL)  # its services get SIGTERM from the kernel with it
        os.waitpid(self._pid, 0)
        os.close(self._read_end)
        return events

    def _signal(self, number: int) -> None:
        if self._identity is not None:
            self._identity.signal(number)

    def _take(self) -> Iterator[Event]:
        try:
            while not self._ended:
                block = os.read(self._read_end, 65536)
                self._buffer += block
                self._ended = not block
        except BlockingIOError:
            pass
        *lines, self._buffer = self._buffer.split(b"\n")
        return (json.loads(line) for line in lines)


def fork_keeper(body: Callable[[Report, Signals], int], directory: RunDirectory, attached: bool,
                patience_s: float, claim: DomainClaim) -> KeeperLine:
    """Runs `body` in a forked process whose output goes to the launcher's log, and its events to a
    file beside it. Of the launcher's open files it has the claim alone.

    An attached keeper stops its stack when the launcher dies; a detached one stays.
    """
    read_end, write_end = os.pipe2(os.O_CLOEXEC)
    parent = os.getpid()
    # A request to stop that comes before the keeper listens waits for it, and is not the copy's of ours.
    unblocked = signal.pthread_sigmask(signal.SIG_BLOCK, STOP_SIGNALS)
    try:
        pid = os.fork()
    except OSError as error:
        raise Failure(f"cannot start the keeper process: {error.strerror}") from None
    if pid:
        signal.pthread_sigmask(signal.SIG_SETMASK, unblocked)
        os.close(write_end)
        return KeeperLine(pid, read_end, patience_s)
    code = 1
    try:
        os.setsid()
        _close_all_but((0, 1, 2, write_end, claim.descriptor))
        signals = Signals()
        signal.pthread_sigmask(signal.SIG_SETMASK, unblocked)
        if attached:
            die_with_parent(parent)
        _redirect_output(directory.log_of("launcher"))
        code = body(_reporter(write_end, directory.events), signals)
    except BaseException:  # the last place that can say anything
        traceback.print_exc()
    finally:
        sys.stderr.flush()
        os._exit(code)


def _close_all_but(kept: Iterable[int]) -> None:
    """Locks and lines to other processes are the launcher's: they must end with it."""
    first = 0
    for descriptor in sorted(kept):
        if first < descriptor:  # an empty range would close everything (Python 3.11)
            os.closerange(first, descriptor)
        first = descriptor + 1
    os.closerange(first, os.sysconf("SC_OPEN_MAX"))


def _redirect_output(log_file: Path) -> None:
    log = os.open(log_file, os.O_WRONLY | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o644)
    nothing = os.open(os.devnull, os.O_RDWR | os.O_CLOEXEC)
    os.dup2(nothing, 0)
    os.dup2(log, 1)
    os.dup2(log, 2)


def _reporter(write_end: int, events: Path) -> Report:
    def report(event: Event) -> None:
        now = time.strftime("%Y-%m-%d %H:%M:%S")
        rest = " ".join(f"{key}={value}" for key, value in event.items() if key != "event")
        line = json.dumps(event).encode() + b"\n"
        with suppress(OSError):  # the disk may be full
            print(f"[{now}] {event['event']} {rest}", file=sys.stderr, flush=True)
            with open(events, "ab", buffering=0) as file:
                file.write(line)
        with suppress(OSError):  # nobody listens any more, as after `up`
            os.write(write_end, line)

    return report
