"""What the services of the running stacks say of themselves: clock jumps, real-time care."""

from typing import Iterator, List, Tuple

from .finding import Finding, note, ok, problem
from .subject import Subject


def clock(subject: Subject) -> List[Finding]:
    """The tick master compares the system's clock with the steady one, and counts jumps."""
    found = []
    for name, counters in _counters(subject):
        jumps = counters.get("clock_jumps", 0)
        if jumps:
            found.append(problem(
                f"the system clock jumped {_times(jumps)} while {name} ran: time stamps before and "
                "after do not fit together (ticks are paced by another clock and go on)",
                "Set the clock before a stack is started, and let one service steer it slowly "
                "(chrony, systemd-timesyncd); then deploy/scarab down and up again."))
    return found or [ok("no jumps were seen" if subject.running else "no stack runs to tell of jumps")]


def care(subject: Subject) -> List[Finding]:
    """Whether a tick master in real time got what it asked the system for."""
    found = []
    for name, counters in _counters(subject):
        for counter, text in (("memory_locked", "its memory is not locked"),
                              ("priority_raised", "its priority is not raised")):
            if counters.get(counter) == 0:
                found.append(note(f"{name}: {text}", "Its log says why: deploy/scarab logs "
                                  f"{name.split('/')[0]}"))
    return found


def _counters(subject: Subject) -> Iterator[Tuple[str, dict]]:
    for report in subject.reports:
        yield f"{report['service']}/{report['instance']}", report["counters"]


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"
