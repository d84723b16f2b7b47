"""How fast a stack goes: as asked for, else as is usual, else as its tick master can."""

from typing import Optional

from .failure import UsageError
from .stack import Pace, Stack


def choose_pace(stack: Stack, wanted: Optional[Pace], usual: Pace) -> Pace:
    """UsageError for a pace that the tick master, here or elsewhere, cannot go at."""
    master = next((s for s in (*stack.services, *stack.elsewhere) if s.tick_master), None)
    possible = master.paces if master else tuple(Pace)
    if wanted is None:
        return usual if usual in possible else possible[0]
    if wanted not in possible:
        raise UsageError(f"--{wanted.value}: {master.name} goes {possible[0].words} only. Leave the option out")
    return wanted
