"""One run of a stack: everything that was decided about it before anything starts."""

from dataclasses import dataclass

from .run_directory import RunDirectory
from .stack import Bus, Pace, Stack


@dataclass(frozen=True)
class StackRun:
    """The stack, where on DDS, how fast, and where it leaves its files."""

    stack: Stack
    bus: Bus
    pace: Pace
    directory: RunDirectory
