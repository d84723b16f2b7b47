"""One stack at one moment: its processes, what its services say, and what is wrong with it."""

import statistics
from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

from ..running_stack import RunningStack
from .processes import CpuMeter, ProcessView, expected_processes, processes_of
from .waits import name_of, waits

_REFUSED = ("commands_refused_", "targets_clamped_")
_PAUSED = "paused by the operator"
_NOTHING_SAID: Dict[str, object] = {"tick_master": "", "services": []}


@dataclass(frozen=True)
class Picture:
    """`said` is the document of scarab-status, or None where it could not be had."""

    stack: RunningStack
    processes: List[ProcessView]
    cpu_percent: Dict[str, float]
    said: Optional[dict]

    @property
    def services(self) -> Dict[Tuple[str, int], dict]:
        return {(s["service"], s["instance"]): s for s in self._document["services"]}

    @property
    def tick_master(self) -> Optional[dict]:
        """The report of the one with the clock."""
        return next((s for s in self.services.values()
                     if name_of(s) == self._document["tick_master"]), None)

    @property
    def in_trial(self) -> bool:
        """Whether the tick master is: one that has lost its robot is inactive, but goes on ticking, in a safe stop."""
        master = self.tick_master
        return bool(master) and (master["lifecycle"] == "active" or (_unwell(master) and master["ticks_per_s"] > 0))

    @property
    def ticks_per_s(self) -> float:
        """Of the chain: the median of those in the trial, for each alone is right to a tick only."""
        rates = [s["ticks_per_s"] for s in self.services.values() if s["lifecycle"] == "active"]
        return statistics.median(rates) if rates else 0.0

    @property
    def real_time_factor(self) -> float:
        master = self.tick_master
        if not master or not master["tick"]:
            return 0.0
        return self.ticks_per_s * master["sim_time_s"] / master["tick"]

    @property
    def elsewhere(self) -> List[dict]:
        """Reports of services that this launcher has not started: on another host, or by hand."""
        own = {p.service for p in self.processes if p.speaks}
        return [s for key, s in self.services.items() if key not in own]

    def waits(self) -> List[str]:
        expected = {part.split("=")[0] for part in self.stack.expected.split(",")}
        return waits(self._document["services"], expected)

    def refused(self) -> Dict[str, Dict[str, int]]:
        """Service -> what was refused or clamped, how often; only what happened."""
        found = {name_of(s): {name: count for name, count in s["counters"].items()
                              if name.startswith(_REFUSED) and count}
                 for s in self.services.values()}
        return {name: counts for name, counts in found.items() if counts}

    def troubles(self) -> List[str]:
        """What is wrong, in words; empty for a stack that is well."""
        found = [] if self.stack.ready else ["the stack is starting or stopping"]
        found += [_absence(p) for p in self.processes if p.pid is None]
        found += [f"{p.name} crashes again and again: {p.crashes.last_end}"
                  for p in self.processes if p.pid and p.crashes.looping]
        found += [f"{name_of(s)} is {s['health']}: {s['message'] or 'it does not say why'}"
                  for s in self.services.values() if _unwell(s)]
        return found + self._silent() + self.waits_that_trouble()

    def waits_that_trouble(self) -> List[str]:
        return [text for text in self.waits() if _PAUSED not in text]

    @property
    def _document(self) -> dict:
        return self.said or _NOTHING_SAID

    def _silent(self) -> List[str]:
        """Those who should be there, and of whom nothing is heard."""
        if self.said is None:
            return []
        dead = {p.service for p in self.processes if p.pid is None}
        silent = []
        for name in expected_processes(self.stack.expected):
            key = ProcessView(name).service
            if key not in self.services and key not in dead:
                silent.append(f"{key[0]}/{key[1]} says nothing on DDS domain {self.stack.bus.domain}; "
                              "deploy/scarab doctor looks for the reason")
        return silent


def take_picture(stack: RunningStack, meter: CpuMeter, said: Optional[dict]) -> Picture:
    processes = processes_of(stack)
    percent = {p.name: meter.percent(p) for p in processes if p.pid is not None}
    return Picture(stack, processes, percent, said)


def _absence(process: ProcessView) -> str:
    how = f"; it {process.crashes.last_end}" if process.crashes.last_end else ""
    return f"{process.name} does not run{how}; see deploy/scarab logs {process.name}"


def _unwell(service: dict) -> bool:
    return service["health"] in ("degraded", "fault")
