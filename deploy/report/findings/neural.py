"""Findings on the network: CPG (Fig. 2), PSN (Fig. 3), VRN (Fig. 4)."""

import math
from typing import Dict, List

from ..experiment import Experiment
from ..neural import TABLE_ROWS, Recording, recording, table_recordings
from ..oscillation import Orbit, amplitude, correlation, line_through, orbit
from ..psn_row import switching
from .finding import Finding, Verdict, graded

_CLOSED = 0.02  # of the mean radius: how far a state may lie off the curve through its neighbours
_SAME, _SAME_BIAS = 0.02, 0.002  # of a weight or an amplitude, as a share; of a bias
_INVERTED = ("table-soft-push", "table-boxing", "table-hard-push")


def cpg_oscillates(experiment: Experiment) -> Finding:
    _, found, c1, c2 = cpg(experiment)
    quarter = math.degrees(math.acos(max(-1.0, min(1.0, correlation(c1, c2)))))
    met = [min(amplitude(c1), amplitude(c2)) > 0.5, abs(quarter - 90) < 10]
    statement = "The two neurons of the CPG swing with one period, one behind the other."
    return Finding("cpg_periodic", statement, graded(met), [
        f"period {found.period_ticks:.2f} ticks, {found.period_ticks / 10:.3f} s at 10 Hz",
        f"amplitude {amplitude(c1):.3f} (C1), {amplitude(c2):.3f} (C2)", f"{quarter:.0f}° between them"])


def cpg_quasi_periodic(experiment: Experiment) -> Finding:
    _, found, c1, _ = cpg(experiment)
    closed, repeats = found.scatter < _CLOSED, found.repeats
    reasons = [] if closed else ["the states do not lie on one closed curve"]
    reasons += ["states repeat, so the orbit is periodic"] if repeats else []
    statement = "In phase space the CPG has a quasi-periodic attractor: a closed curve that it never repeats on."
    return Finding("cpg_quasi_periodic", statement, graded([closed, not repeats]), [
        f"{len(c1)} states lie within {100 * found.scatter:.2f} % of one closed curve",
        f"the nearest two are {found.nearest_return:.1e} of the radius apart"], "; ".join(reasons))


def cpg(experiment: Experiment) -> "tuple[Recording, Orbit, List[float], List[float]]":
    found = recording(experiment, experiment.strategies[0])
    c1, c2 = found.settled("C1"), found.settled("C2")
    return found, orbit(c1, c2), c1, c2


def psn_rows(experiment: Experiment) -> Finding:
    met, numbers, wrong = [], [], []
    for found in table_recordings(experiment):
        seen = switching(found, "PSN1")
        expected = "invert" if found.strategy in _INVERTED else "pass"
        met.append(seen.word == expected)
        numbers.append(f"{found.row}: {seen.word} (correlation of P13 {seen.p13:+.3f}, of P14 {seen.p14:+.3f})")
        if not met[-1]:
            wrong.append(f"{found.row} should {expected}")
    if len(met) < len(TABLE_ROWS):
        wrong.append(f"{len(met)} of {len(TABLE_ROWS)} rows were run")
    statement = ("PSN1 passes its inputs on for (I1, I2) = (1, 1) and (0, 1), and inverts them for (1, -1), (-1, -1) "
                 "and (1, 0).")
    return Finding("psn_rows", statement, graded(met), numbers, "; ".join(wrong))


def psn_amplitude(experiment: Experiment) -> Finding:
    sizes = {module: [switching(found, module).amplitude for found in table_recordings(experiment)]
             for module in ("PSN1", "PSN2", "PSN3", "PSN4")}
    statement = "The outputs of the PSN keep an amplitude as high as possible, between -0.5 and +0.5."
    return Finding("psn_amplitude", statement, graded([max(size) <= 0.5 for size in sizes.values()]),
                   [f"{module}: amplitude {min(size):.2f} to {max(size):.2f}" for module, size in sizes.items()])


def vrn_order(experiment: Experiment) -> Finding:
    of = _amplitudes(experiment, "VRN1.V7")
    statement = ("VRN1 sets the amplitude of the hind legs' C-joints by the action: full for walking and for hard "
                 "pushing, less for boxing, least for soft pushing (from the paper's equations of V1, w9 and w10).")
    if len(of) < len(TABLE_ROWS):
        return Finding("vrn_order", statement, Verdict.OPEN, [f"{len(of)} of {len(TABLE_ROWS)} rows were run"])
    soft, boxing, hard = (of[name] for name in _INVERTED)
    full = min(of["table-forward"], of["table-backward"], hard)
    alike = max(of["table-forward"], of["table-backward"], hard) - full < _SAME * full
    return Finding("vrn_order", statement, graded([alike, full > boxing > soft]),
                   [f"{TABLE_ROWS[name]}: {value:.3f}" for name, value in of.items()],
                   "" if alike else "walking and hard pushing differ")


def vrn_synapses(experiment: Experiment) -> Finding:
    """Weights and bias as the signals show them: atanh(V2) one tick later is a straight line over its input."""
    met, numbers = [], []
    for found in table_recordings(experiment):
        soft = found.strategy == "table-soft-push"
        source, weight, bias = ("PSN1.P13", 1.0, 0.0) if soft else ("C1", 2.0, 0.02)
        slope, start = line_through(found.settled(source)[:-1], list(map(math.atanh, found.settled("VRN1.V2")[1:])))
        met.append(abs(slope - weight) < _SAME and abs(start - bias) < _SAME_BIAS)
        numbers.append(f"{found.row}: {slope:.3f} × {source} {'-' if start < -0.0005 else '+'} {abs(start):.3f}")
    statement = ("V2 of VRN1 gets 2 C1 + 0.02 (w9, b3) in all actions but soft pushing, where it gets P13 of PSN1 "
                 "alone (w10 = 1).")
    return Finding("vrn_synapses", statement, graded(met), numbers)


def _amplitudes(experiment: Experiment, neuron: str) -> Dict[str, float]:
    return {found.strategy: amplitude(found.settled(neuron)) for found in table_recordings(experiment)}


CPG = (cpg_oscillates, cpg_quasi_periodic)
PSN = (psn_rows, psn_amplitude)
VRN = (vrn_order, vrn_synapses)
