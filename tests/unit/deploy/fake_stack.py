"""A launcher with fake programs in a folder of the test, on a DDS domain nobody else claims."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SOURCE_ROOT = Path(__file__).resolve().parents[3]
SCARAB = SOURCE_ROOT / "deploy" / "scarab"
PATIENCE_S = 30.0
PROGRAMS = ("scarab-logger", "scarab-plant", "scarab-premotor", "scarab-supervisor",
            "scarab-robot-bridge", "scarab-emulator",
            "scarab-status", "scarab-experiment", "scarab-log", "scarab-operator", "scarab-sim",
            "scarab-topic", "scarab-drive", "scarab-config")

sys.path.insert(0, str(SOURCE_ROOT / "deploy"))

STACK = """
bus: {interface: lo, tag: ""}
log_level: info
timing: {ready_s: 20}
restart: {first_s: 0.01, longest_s: 0.05, forget_s: 30}
services:
  logger: {binary: scarab-logger, instances: 1, restart: always, stop_s: 20}
  plant: {binary: scarab-plant, instances: 1, restart: between_trials, stop_s: 20, tick_master: true}
  premotor: {binary: scarab-premotor, instances: 1, restart: always, stop_s: 20}
profiles:
  sim: {services: [logger, plant, premotor]}
"""


def wait_until(condition, what):
    deadline = time.monotonic() + PATIENCE_S
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"waited in vain until {what}")
        time.sleep(0.01)


class FakeStackTest(unittest.TestCase):
    """Each test has its own programs, runs and stack file; what it leaves running is a failure."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="scarab-launcher-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.bin = self.folder / "bin"
        self.runs = self.folder / "runs"
        (self.bin / "orders").mkdir(parents=True)
        for name in PROGRAMS:
            shutil.copy(SOURCE_ROOT / "tests/unit/deploy/fake_program.sh", self.bin / name)
            (self.bin / name).chmod(0o755)
            shutil.copy(SOURCE_ROOT / "tests/unit/deploy/fake_program.py", self.bin / f"{name}.py")
        self.stack_file = self.folder / "stack.yaml"
        self.stack_file.write_text(STACK)
        self.addCleanup(self._end_everything)

    def be_impatient(self):
        """Services get one second to stop, in tests of a service that does not."""
        self.stack_file.write_text(STACK.replace("stop_s: 20", "stop_s: 1"))

    def order(self, program, word, text="yes"):
        (self.bin / "orders" / f"{program}.{word}").write_text(text)

    def withdraw(self, program, word):
        (self.bin / "orders" / f"{program}.{word}").unlink()

    def start(self, verb, *words):
        """The launcher in a session of its own, as a terminal would start it."""
        return subprocess.Popen(
            [str(SCARAB), verb, "--stack", str(self.stack_file), "--bin", str(self.bin),
             "--runs", str(self.runs), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True, start_new_session=True,
            env={**os.environ, "CYCLONEDDS_URI": "file:///nowhere"})

    def finish(self, launcher):
        """(exit code, standard output, standard error)"""
        out, err = launcher.communicate(timeout=PATIENCE_S)
        return launcher.returncode, out, err

    def scarab(self, verb, *words):
        return self.finish(self.start(verb, *words))

    def command_of(self, program):
        """The options a program was started with last: {name: value}."""
        words = (self.bin / f"{program}.command").read_text().splitlines()
        return dict(zip(words, words[1:]))

    def journal(self):
        """[(what, program)], in the order of happening."""
        return [tuple(line.split()[:2]) for line in self._journal_lines()]

    def living(self):
        """Programs of this test that still run."""
        return [line for line in self._journal_lines() if self._lives(int(line.split()[2]))]

    def run_directory(self):
        return (self.runs / "latest").resolve()

    def trial_runs(self):
        return (self.bin / "trial-runs").exists()

    def _journal_lines(self):
        file = self.bin / "journal"
        return file.read_text().splitlines() if file.exists() else []

    def _lives(self, pid):
        try:
            command = Path(f"/proc/{pid}/cmdline").read_bytes()
        except OSError:
            return False
        return str(self.bin).encode() in command

    def _end_everything(self):
        left = self.living()
        self.scarab("down")
        for line in left:
            pid = int(line.split()[2])
            if self._lives(pid):
                os.kill(pid, signal.SIGKILL)
