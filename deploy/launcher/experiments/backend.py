"""Who runs the trials of an experiment: processes with all cores, or stacks of processes."""

from dataclasses import dataclass
from typing import List, Protocol, Sequence

from ..launch import check
from ..places import Places
from ..signals import Signals
from ..stack import LOGGER, Stack
from .configuration import SIMULATED, stack_that_reads
from .directory import ExperimentDirectory
from .in_process_seat import InProcessSeat
from .seat import Seat
from .stack_seat import StackSeat

_PROGRAMS_OF_A_STACK = ("scarab-experiment", "scarab-status")


class Backend(Protocol):
    """Both give the same results, byte for byte."""

    words: str

    def check(self, places: Places) -> None:
        """Failure where a program is not built."""

    def seats(self, places: Places, directory: ExperimentDirectory, record: bool,
              signals: Signals) -> List[Seat]:
        """Nothing is started as yet."""


@dataclass(frozen=True)
class InProcess:
    """`jobs` processes of scarab-sim."""

    jobs: int

    @property
    def words(self) -> str:
        return f"in process ({self.jobs} at a time)"

    def check(self, places: Places) -> None:
        places.program("scarab-sim")

    def seats(self, places: Places, directory: ExperimentDirectory, record: bool,
              signals: Signals) -> List[Seat]:
        return [InProcessSeat(n + 1, places, directory, record) for n in range(self.jobs)]


@dataclass(frozen=True)
class Stacks:
    """`count` stacks side by side, each on a DDS domain of its own; with a logger only where trials are
    recorded."""

    count: int
    stack: Stack

    @property
    def words(self) -> str:
        return f"on {self.count} stack{'s' if self.count > 1 else ''} of processes"

    def check(self, places: Places) -> None:
        services = self._members(True).services
        for program in (*_PROGRAMS_OF_A_STACK, *(service.binary for service in services)):
            places.program(program)

    def seats(self, places: Places, directory: ExperimentDirectory, record: bool,
              signals: Signals) -> List[Seat]:
        directory.stacks.mkdir(exist_ok=True)
        checked = check(places, stack_that_reads(self._members(record), directory.config))
        return [StackSeat(n + 1, places, checked, directory, record, signals) for n in range(self.count)]

    def _members(self, record: bool) -> Stack:
        names: Sequence[str] = (LOGGER, *SIMULATED) if record else SIMULATED
        return self.stack.only(names)
