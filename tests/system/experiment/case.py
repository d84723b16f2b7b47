"""Experiments with the real programs, in folders of their own."""

import json
import os
import re
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

SOURCE_ROOT = Path(__file__).resolve().parents[3]
SCARAB = SOURCE_ROOT / "deploy" / "scarab"
BIN = Path(os.environ.get("SCARAB_BIN") or SOURCE_ROOT / "build" / "release" / "bin")
PATIENCE_S = 60.0
IN_PROCESS, ON_STACKS = ("--inproc", "--jobs", "2"), ("--stacks", "2")

# Half of its trials succeed: the object is there after some 5 s.
EXPERIMENT = """
title: A tiny experiment
figure: obstacle
paper: [Says little.]
grids:
  - distance_m: [0.1, 9.0]
    strategy: [soft, boxing]
every_trial: {goal: travel, height_m: 0.0, time_limit_s: 15}
trials: 4
first_seed: 1000001
perturbation: {position_m: 0.02, yaw_rad: 0.05, friction: 0.1, cpg_phase: true}
"""
TRIALS = 16


class ExperimentCase(unittest.TestCase):
    """What it leaves running, or claimed, is a failure."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="scarab-experiment-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.addCleanup(self._nothing_is_left, claimed_domains())
        self.file = self.folder / "tiny.yaml"
        self.file.write_text(EXPERIMENT)

    def start(self, *words):
        return subprocess.Popen([str(SCARAB), "experiment", *words, "--bin", str(BIN),
                                 "--runs", str(self.folder / "runs")], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, start_new_session=True)

    def experiment(self, *words):
        """Its standard output; it has to succeed."""
        launcher = self.start(*words)
        out, err = launcher.communicate(timeout=PATIENCE_S)
        self.assertEqual(launcher.returncode, 0, err)
        return out

    def run_into(self, name, *words):
        """The directory of the tiny experiment, run there."""
        directory = self.folder / name
        self.experiment(str(self.file), "--no-report", "--out", str(directory), *words)
        return directory

    def stopped_in_the_middle(self, name, number, *words):
        """The same, but for a signal to the launcher after the first results: (directory, exit code, stderr)."""
        directory = self.folder / name
        launcher = self.start(str(self.file), "--no-report", "--out", str(directory), *words)
        wait_until(lambda: launcher.poll() is not None or len(done(directory)) >= 2, "two trials have been run")
        os.kill(launcher.pid, number)
        _, err = launcher.communicate(timeout=PATIENCE_S)
        wait_until(lambda: not self.living(), "everything has ended")
        self.assertLess(len(done(directory)), TRIALS, "it was not in the middle")
        return directory, launcher.returncode, err

    def living(self):
        """Command lines of processes that work for this test."""
        return [line for line in command_lines() if str(self.folder) in line]

    def _nothing_is_left(self, claimed_before):
        self.assertEqual(self.living(), [])
        self.assertEqual(claimed_domains(), claimed_before)


def table(directory):
    return (directory / "results.csv").read_bytes()


def done(directory):
    """Indices of the trials that have a result."""
    file = directory / "journal.jsonl"
    lines = file.read_text().split("\n")[:-1] if file.exists() else []
    return [json.loads(line)["index"] for line in lines]


def command_lines():
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            yield (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
        except OSError:  # it has ended meanwhile
            continue


def claimed_domains():
    """Of all launchers in this network namespace."""
    return sorted(re.findall(r"@scarab-domain-(\d+)", Path("/proc/net/unix").read_text()))


def wait_until(condition, what):
    deadline = time.monotonic() + PATIENCE_S
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"waited in vain until {what}")
        time.sleep(0.01)
