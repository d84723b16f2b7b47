"""What is stated, by kind of experiment, and whether the trials show it."""

from typing import Callable, Dict, List, Optional, Tuple

from ..experiment import Experiment
from ..failure import ReportError
from . import beyond, flat, neural, obstacle, robustness, sequence, walking
from .finding import Finding, Source, Verdict

TABLE: Dict[str, Tuple[Callable[[Experiment], Optional[Finding]], ...]] = {
    "cpg": neural.CPG,
    "psn": neural.PSN,
    "vrn": neural.VRN,
    "transport_speed": flat.FINDINGS,
    "obstacle": obstacle.FINDINGS,
    "sequence": sequence.FINDINGS,
    "walking": walking.FINDINGS,
    "beyond": beyond.FINDINGS,
    "robustness": robustness.FINDINGS,
}


def findings(experiment: Experiment) -> List[Finding]:
    """All of the experiment's kind that its plan can show; one whose data are missing is said not to be measured."""
    found: List[Optional[Finding]] = []
    for judge in TABLE[experiment.plan.figure]:
        try:
            found.append(judge(experiment))
        except ReportError as error:
            found.append(Finding(judge.__name__, judge.__name__.replace("_", " "), Verdict.OPEN, [], str(error)))
    return [finding for finding in found if finding is not None]
