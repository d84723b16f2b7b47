"""How the phase switching networks switch in one row of Table 1."""

from dataclasses import dataclass

from .neural import PSN_LAYERS, Recording
from .oscillation import amplitude, delayed_correlation

LIKE = 0.95  # smallest correlation with the delayed signal that counts as its form


@dataclass(frozen=True)
class Switching:
    """Correlations of both outputs with the module's first input, four ticks before."""

    p13: float
    p14: float
    amplitude: float  # the larger of both outputs

    @property
    def word(self) -> str:
        if self.p13 >= LIKE and self.p14 <= -LIKE:
            return "pass"
        if self.p13 <= -LIKE and self.p14 >= LIKE:
            return "invert"
        return "neither"


def switching(recording: Recording, module: str) -> Switching:
    """Of a settled recording: whether the module passes its signal on or inverts it."""
    source = recording.settled("C1" if module in ("PSN1", "PSN2") else "PSN1.P13")
    outputs = [recording.settled(f"{module}.{neuron}") for neuron in ("P13", "P14")]
    return Switching(*(delayed_correlation(output, source, PSN_LAYERS) for output in outputs),
                     max(map(amplitude, outputs)))
