"""A test case with an experiment of its own."""

import tempfile
import unittest
from pathlib import Path
from typing import Callable, List, Optional, Sequence

from made_up import Row, outcome, write_plan, write_results
from made_up_log import FAKE_BIN

from report.experiment import Experiment, read_experiment
from report.findings import findings
from report.findings.finding import Finding


class ScratchDirectory(unittest.TestCase):
    """Removed after each test."""

    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)

    def experiment(self, kind: str, trials: Sequence[Row], run: Optional[Callable[[Row], Row]] = None,
                   done: Optional[int] = None) -> Experiment:
        """Written and read; `done` of its trials have been run."""
        directory = self.room / kind
        write_plan(directory, trials, kind)
        write_results(directory, trials[:done], run or (lambda asked: outcome()))
        return read_experiment(directory, FAKE_BIN)

    def judged(self, experiment: Experiment) -> List[Finding]:
        return findings(experiment)

    def verdicts(self, experiment: Experiment) -> dict:
        return {finding.name: finding.word for finding in findings(experiment)}
