"""Where trials are run, one after the other."""

from typing import List, Optional, Protocol

from .plan import PlannedTrial


class Fault(Exception):
    """The trial that was given cannot be run here now; the text says why. The seat has to be cleared before
    it is used again."""


class Seat(Protocol):
    """One trial at a time. Nothing blocks but clear(), and what a recorded trial needs to be closed."""

    name: str

    def give(self, trial: PlannedTrial) -> None:
        """Begins with it, and starts whatever that needs."""

    def descriptors(self) -> List[int]:
        """What to wait for until the next look."""

    def look(self) -> Optional[str]:
        """The line that answers the trial, once it is there. Fault where none will come."""

    def ask_to_end(self) -> None:
        """Everything that runs here, without waiting."""

    def clear(self) -> None:
        """Ends everything that runs here."""
