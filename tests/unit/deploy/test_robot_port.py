"""The port of a robot, and the driver that speaks there."""

import os
import tempfile
import unittest
from pathlib import Path

from robot_case import STACK, RobotCase  # finds the launcher
from launcher.failure import UsageError
from launcher.stack_changes import StackChanges
from launcher.stack_file import read_stack

RobotCase.domain = 60  # test_robot runs beside it


class Port(RobotCase):
    def fails(self, *words):
        """What is said of a port; nothing was started."""
        code, out, err = self.scarab("up", *self.words, *words)
        self.assertEqual((code, out), (1, ""), err)
        self.assertEqual(self.journal(), [])
        self.assertFalse(self.runs.exists())
        return err

    def test_configured_one_is_left_to_the_bridge(self):
        self.configure(self.a_port())
        self.assertEqual(self.scarab("up", *self.words)[0], 0)
        self.assertNotIn("--device", self.command_of("scarab-robot-bridge"))
        self.assertNotIn(("start", "scarab-emulator"), self.journal())

    def test_other_one_is_handed_to_the_bridge_alone(self):
        self.configure("/dev/no-such-port")
        port = self.a_port()
        self.assertEqual(self.scarab("up", *self.words, "--device", port)[0], 0)
        self.assertEqual(self.command_of("scarab-robot-bridge")["--device"], port)
        self.assertNotIn("--device", self.command_of("scarab-logger"))

    def test_one_that_is_not_there_is_said_at_once(self):
        self.configure("/dev/no-such-port")
        self.assertRegex(self.fails(), "there is no /dev/no-such-port. Plug the robot in, .*--device PATH.*--emulated")
        self.assertIn("there is no /dev/nor-this", self.fails("--device", "/dev/nor-this"))

    def test_one_that_is_no_serial_port(self):
        self.configure(self.stack_file)
        self.assertIn(f"{self.stack_file} is no serial port", self.fails())
        self.assertIn("/dev/null is no serial port", self.fails("--device", "/dev/null"))

    def test_one_that_somebody_else_has_open(self):
        port = self.a_port()
        self.configure(port)
        held = os.open(port, os.O_RDWR | os.O_NOCTTY)
        self.addCleanup(os.close, held)
        self.assertRegex(self.fails(), rf"{port} is open in test_robot_port.py \(pid {os.getpid()}\)")

    def test_driver_without_a_port_needs_none(self):
        self.order("scarab-robot-bridge", "configuration", "driver: amosii\namosii: {delay_s: 0}\n")
        self.assertEqual(self.scarab("up", *self.words)[0], 0)


class Doctor(RobotCase):
    def finding(self, *words):
        code, out, err = self.scarab("doctor", "device", *words)
        self.assertEqual(err, "")
        return code, " ".join(out.split())

    def test_port(self):
        port = self.a_port()
        self.configure(port)
        self.assertEqual(self.finding(*self.words),
                         (0, f"ok device {port} is there, may be opened, and is free no problems"))
        held = os.open(port, os.O_RDWR | os.O_NOCTTY)
        code, text = self.finding(*self.words)
        os.close(held)
        self.assertEqual(code, 1)
        self.assertRegex(text, rf"PROBLEM device {port} is open in test_robot_port.py .* garble each other's frames.")
        code, text = self.finding(*self.words, "--device", "/dev/no-such-port")
        self.assertEqual(code, 1)
        self.assertIn("there is no /dev/no-such-port", text)

    def test_profile_without_a_robot(self):
        self.assertEqual(self.finding("--profile", "sim"), (0, "ok device the profile drives no robot no problems"))

    def test_robot_that_nobody_asks_for_is_told_of_and_not_missed(self):
        self.configure("/dev/no-such-port")
        code, text = self.finding(*self.words[2:])
        self.assertEqual(code, 0, text)
        self.assertIn("ok device no stack runs that could drive a robot, and none is where it is configured", text)
        port = self.a_port()
        self.configure(port)
        self.assertEqual(self.finding(*self.words[2:]), (0, f"ok device a robot may be at {port}, which is free: `up "
                                                            "--profile robot` drives it no problems"))

    def test_stack_that_is_up_is_judged_by_its_own_files(self):
        self.configure("/dev/no-such-port")
        port, link = self.a_port(), self.folder / "robot"
        link.symlink_to(port)
        self.order("scarab-robot-bridge", "open")
        self.assertEqual(self.scarab("up", *self.words, "--device", str(link))[0], 0)
        domain, where = self.words[2:], f"the stack on DDS domain {self.words[3]}"
        self.assertEqual(self.finding(*domain),
                         (0, f"ok device {link} is open in robot_bridge of {where} no problems"))
        held = os.open(port, os.O_RDWR | os.O_NOCTTY)
        code, text = self.finding(*domain)
        os.close(held)
        self.assertEqual(code, 1)
        self.assertRegex(text, f"PROBLEM device {link}, the robot of {where}, is open in test_robot_port.py .*, too")
        link.unlink()
        code, text = self.finding(*domain)
        self.assertEqual(code, 1)
        self.assertIn(f"PROBLEM device the robot of {where} is not at {link} Plug it in again", text)

    def test_stack_that_is_up_and_does_not_have_its_robot_open(self):
        self.configure(self.a_port())
        self.assertEqual(self.scarab("up", *self.words)[0], 0)
        code, text = self.finding(*self.words[2:])
        self.assertEqual(code, 0)
        self.assertIn("note device /dev/pts/", text)
        self.assertIn("does not have it open deploy/scarab status says what it waits for", text)

    def test_emulated_robot_of_a_stack_that_is_up(self):
        self.configure("/dev/no-such-port")
        self.assertEqual(self.scarab("up", *self.words, "--emulated")[0], 0)
        (self.run_directory() / "device").unlink()
        code, text = self.finding(*self.words[2:])
        self.assertEqual(code, 1)
        self.assertIn(f"the emulated robot of the stack on DDS domain {self.words[3]} is not at ", text)

    def test_stack_that_drives_no_robot(self):
        self.assertEqual(self.scarab("up", *self.words[2:])[0], 0)
        self.assertEqual(self.finding(*self.words[2:]), (0, f"ok device the stack on DDS domain {self.words[3]} drives "
                                                            "no robot here no problems"))


class Drivers(unittest.TestCase):
    """Those that a robot has a configuration for, in a source tree of the test's own."""

    files = ("robot/beetle.yaml", "robot/beetle-long.yaml", "robot/ant.yaml", "robot_bridge/beetle-amosii.yaml",
             "robot_bridge/beetle-dynamixel.yaml", "robot_bridge/beetle-long-loopback.yaml")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in self.files:
            (self.root / "config" / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / "config" / name).write_text("")
        self.stack_file = self.root / "stack.yaml"
        self.stack_file.write_text(STACK.replace("FOLDER/bridge-", "config/robot_bridge/{robot}-").replace(
            "FOLDER/robot", "config/robot/{robot}"))

    def read(self, profile="robot", **changes):
        return read_stack(self.stack_file, profile, self.root, StackChanges(**changes))

    def test_file_of_the_robot_and_the_driver_is_chosen(self):
        for changes, name in (({}, "beetle-amosii"), ({"driver": "dynamixel"}, "beetle-dynamixel"),
                              ({"robot": "beetle-long", "driver": "loopback"}, "beetle-long-loopback")):
            stack = self.read(**changes)
            self.assertEqual(stack.service("robot_bridge").config,
                             self.root / "config" / "robot_bridge" / f"{name}.yaml")
            self.assertEqual(stack.driver, changes.get("driver", "amosii"))

    def test_profile_without_a_bridge_has_no_driver(self):
        self.assertEqual(self.read("sim").driver, "")

    def test_unknown_one_is_named_with_those_that_there_are(self):
        for changes, reason in (
                ({"driver": "dynamixl"}, r"unknown driver 'dynamixl' \(did you mean 'dynamixel'\?\); "
                                         "for robot 'beetle' config/robot_bridge has amosii, dynamixel$"),
                ({"robot": "ant", "driver": "amosii"}, "for robot 'ant' config/robot_bridge has none"),
                ({"robot": "ant"}, "robot 'ant', driver 'amosii' has no config/robot_bridge/ant-amosii.yaml, which "
                                   "service robot_bridge reads")):
            with self.assertRaisesRegex(UsageError, reason):
                self.read(**changes)


if __name__ == "__main__":
    unittest.main()
