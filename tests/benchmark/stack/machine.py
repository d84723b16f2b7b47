"""Who had the processors while something was measured."""

import os
import resource
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Usage:
    """Processor seconds since the machine's start; `own`: of this process and its ended children."""
    all_s: float
    busy_s: float
    own_s: float

    @staticmethod
    def now() -> "Usage":
        # proc(5): user nice system idle iowait irq softirq steal
        ticks = [int(word) for word in Path("/proc/stat").read_text().splitlines()[0].split()[1:9]]
        per_s = os.sysconf("SC_CLK_TCK")
        whose = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
        return Usage(sum(ticks) / per_s, (sum(ticks) - ticks[3] - ticks[4]) / per_s,
                     sum(usage.ru_utime + usage.ru_stime for usage in whose))

    def share_of_others(self) -> float:
        """Of all processor time from this moment to now; children that live on count as others."""
        now = Usage.now()
        others_s = now.busy_s - self.busy_s - (now.own_s - self.own_s)
        return max(0.0, others_s / max(now.all_s - self.all_s, 1e-9))
