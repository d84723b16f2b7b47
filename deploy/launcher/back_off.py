"""How long to wait before a crashed service is started again."""

from .stack import BackOffTimes


class BackOff:
    """Doubles the wait at each crash up to a cap; a long good run starts it over."""

    def __init__(self, times: BackOffTimes):
        self._times = times
        self._next_s = times.first_s
        self.restarts = 0

    def crashed(self, ran_s: float) -> float:
        """Counts a crash after `ran_s` seconds; returns the wait before the restart, in seconds."""
        if ran_s >= self._times.forget_s:
            self._next_s = self._times.first_s
        wait_s = self._next_s
        self._next_s = min(2.0 * self._next_s, self._times.longest_s)
        self.restarts += 1
        return wait_s
