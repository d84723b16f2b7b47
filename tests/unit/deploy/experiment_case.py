"""A tiny experiment, and a launcher that runs it with fake programs."""

import json
from pathlib import Path

from fake_stack import STACK, FakeStackTest, wait_until

EXPERIMENT = """
title: A tiny experiment
figure: obstacle
paper: [Says little.]
grids:
  - strategy: [soft, soft+hard]
    height_m: [0.05, 0.1]
every_trial: {goal: across, distance_m: 1.46, time_limit_s: 60}
trials: 3
first_seed: 1000001
perturbation: {position_m: 0.02, yaw_rad: 0.05, friction: 0.1, cpg_phase: true}
"""
TRIALS = 12


class ExperimentTest(FakeStackTest):
    """Its stack has files for the services, as an experiment needs them."""

    whole = None

    def setUp(self):
        super().setUp()
        file = self.folder / "any.yaml"
        file.write_text("")
        text = STACK
        for name in ("plant", "premotor"):
            text = text.replace(f"scarab-{name},", f"scarab-{name}, config: {file}, robot: {file},")
        text = text.replace("scarab-logger,", f"scarab-logger, config: {file},")
        self.stack_file.write_text(text.replace(
            "profiles:", f"  supervisor: {{binary: scarab-supervisor, config: {file}, instances: 1, "
            "restart: always, stop_s: 20}\nprofiles:").replace(
                "[logger, plant, premotor]", "[logger, plant, premotor, supervisor]"))
        self.file = self.folder / "tiny.yaml"
        self.file.write_text(EXPERIMENT)
        self.out = self.folder / "out"

    def words(self, *words):
        return (str(self.file), "--no-report", "--out", str(self.out), *words)

    def experiment(self, *words):
        return self.scarab("experiment", *self.words(*words))

    def start_experiment(self, *words):
        return self.start("experiment", *self.words(*words))

    def results(self, out=None):
        return ((out or self.out) / "results.csv").read_text()

    def journal_indices(self, out=None):
        file = (out or self.out) / "journal.jsonl"
        lines = file.read_text().split("\n")[:-1] if file.exists() else []
        return [json.loads(line)["index"] for line in lines]

    def uninterrupted(self):
        """What the table has to be: of a run that nothing disturbs, the same in every test."""
        if ExperimentTest.whole is None:
            out = self.folder / "uninterrupted"
            code, _, err = self.scarab("experiment", str(self.file), "--no-report", "--out", str(out))
            self.assertEqual(code, 0, err)
            ExperimentTest.whole = self.results(out)
            for file in ("trials", "journal"):
                (self.bin / file).unlink()
        return ExperimentTest.whole

    def wait_for_results(self, count):
        wait_until(lambda: len(self.journal_indices()) >= count, f"{count} trials have been run")

    def trials_run(self):
        """Indices, in the order in which the workers ran them."""
        file = Path(self.bin / "trials")
        return [int(line) for line in file.read_text().split()] if file.exists() else []
