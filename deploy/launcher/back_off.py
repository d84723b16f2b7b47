"""How long to wait before a crashed service is started again."""

from .stack import BackOffTimes

LOOP_AFTER = 5


class BackOff:
    """Doubles the wait at each crash up to a cap; a long good run starts it over."""

    def __init__(self, times: BackOffTimes):
        self._times = times
        self.restarts = 0  # in all
        self.in_a_row = 0  # without a long good run between them

    @property
    def looping(self) -> bool:
        """It crashes again and again: restarting it does not help."""
        return self.in_a_row >= LOOP_AFTER

    def crashed(self, ran_s: float) -> float:
        """Counts a crash after `ran_s` seconds; returns the wait before the restart, in seconds."""
        self.runs_well(ran_s)
        wait_s = min(self._times.first_s * 2.0**min(self.in_a_row, 60), self._times.longest_s)
        self.in_a_row += 1
        self.restarts += 1
        return wait_s

    def runs_well(self, ran_s: float) -> bool:
        """Forgets earlier crashes once it has run long enough; true if there were any to forget."""
        forgets = self.in_a_row > 0 and ran_s >= self._times.forget_s
        if forgets:
            self.in_a_row = 0
        return forgets

    def time_to_forget(self, ran_s: float) -> float:
        """How much longer it has to run for that, in seconds."""
        return max(self._times.forget_s - ran_s, 0.0)
