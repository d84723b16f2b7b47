"""A stack with a robot bridge, of fake programs."""

import os
import pty
import re

from fake_stack import FakeStackTest

STACK = """
robot: beetle
driver: amosii
bus: {interface: lo, tag: ""}
log_level: info
timing: {ready_s: 20}
restart: {first_s: 0.01, longest_s: 0.05, forget_s: 30}
services:
  emulator: {binary: scarab-emulator, hardware: true, plant: FOLDER/plant.yaml, instances: 1, restart: always,
             stop_s: 20}
  logger: {binary: scarab-logger, instances: 1, restart: always, stop_s: 20}
  plant: {binary: scarab-plant, instances: 1, restart: between_trials, stop_s: 20, tick_master: true}
  robot_bridge: {binary: scarab-robot-bridge, instances: 1, restart: between_trials, stop_s: 20, tick_master: true,
                 paces: [realtime], device: true, robot: "FOLDER/robot.yaml", config: "FOLDER/bridge-{driver}.yaml"}
profiles:
  sim: {services: [logger, plant]}
  robot: {services: [logger, robot_bridge], emulated: [emulator]}
"""


class RobotCase(FakeStackTest):
    domain = 20  # before its tests' first

    def setUp(self):
        super().setUp()
        RobotCase.domain += 1
        self.words = ("--profile", "robot", "--domain", str(RobotCase.domain))
        self.stack_file.write_text(STACK.replace("FOLDER", str(self.folder)))
        for name in ("plant", "other-plant", "robot", "bridge-amosii", "calibration"):
            (self.folder / f"{name}.yaml").write_text(f"name: {name}\n")

    def a_port(self):
        """A terminal of the test's own, open at its other end alone."""
        ours, other = pty.openpty()
        self.addCleanup(os.close, ours)
        port = os.ttyname(other)
        os.close(other)
        return port

    def configure(self, port):
        self.order("scarab-robot-bridge", "configuration",
                   f"driver: amosii\namosii: {{port: {port}}}\n"
                   f"calibration: {self.folder}/calibration.yaml\n")

    def refused(self, verb, *words):
        """The one line of it; nothing was started."""
        code, out, err = self.scarab(verb, *words)
        self.assertEqual((code, out), (2, ""), err)
        self.assertEqual(len(err.splitlines()), 1, err)
        self.assertEqual(self.journal(), [])
        self.assertFalse(self.runs.exists())
        return err

    def events(self, word):
        log = (self.run_directory() / "logs" / "launcher.log").read_text()
        return re.findall(rf"{word} service=(\w+)", log)
