"""The profile of a robot: its bridge, and what stands in for the robot."""

import os
import signal
import unittest

import yaml
from fake_stack import wait_until
from robot_case import RobotCase


class Emulated(RobotCase):
    def setUp(self):
        super().setUp()
        self.configure("/dev/no-such-port")  # which nobody may need
        self.words += ("--emulated",)

    def test_emulator_is_there_before_the_bridge_and_after_it(self):
        code, _, err = self.scarab("run", *self.words)
        self.assertEqual(code, 0, err)
        self.assertEqual(self.events("started"), ["emulator", "logger", "robot_bridge"])
        self.assertEqual(self.events("stopped"), ["robot_bridge", "logger", "emulator"])

    def test_bridge_is_started_once_the_device_is_there(self):
        self.assertEqual(self.scarab("run", *self.words)[0], 0)
        journal = self.journal()
        self.assertLess(journal.index(("device", "scarab-emulator")), journal.index(("start", "scarab-robot-bridge")))

    def test_emulator_that_cannot_start_says_why_and_nothing_else_is_started(self):
        self.order("scarab-emulator", "die-at-start")
        code, _, err = self.scarab("run", *self.words)
        self.assertEqual(code, 1)
        self.assertIn("emulator ended with exit code 1 while the stack was starting", err)
        self.assertIn("cannot open the device", err)
        self.assertEqual({name for _, name in self.journal()}, {"scarab-emulator"})

    def test_both_get_the_same_files_and_the_same_device(self):
        self.assertEqual(self.scarab("run", *self.words)[0], 0)
        bridge, emulator = (self.command_of(f"scarab-{name}") for name in ("robot-bridge", "emulator"))
        for option in ("--robot", "--config", "--device"):
            self.assertEqual(bridge[option], emulator[option])
        self.assertEqual(emulator["--config"], str(self.folder / "bridge-amosii.yaml"))
        self.assertEqual(emulator["--device"], str(self.run_directory() / "device"))
        self.assertEqual(emulator["--plant"], str(self.folder / "plant.yaml"))
        self.assertNotIn("--plant", bridge)
        self.assertEqual(bridge["--pace"], "realtime")
        self.assertNotIn("--pace", emulator)

    def test_emulator_is_expected_by_nobody(self):
        self.assertEqual(self.scarab("run", *self.words)[0], 0)
        self.assertEqual(self.command_of("scarab-robot-bridge")["--expect"], "logger=1,robot_bridge=1")

    def test_run_directory_tells_what_was_driven(self):
        self.assertEqual(self.scarab("run", *self.words)[0], 0)
        config = self.run_directory() / "config"
        record = yaml.safe_load((config / "run.yaml").read_text())
        self.assertEqual((record["driver"], record["emulated"], record["pace"]), ("amosii", True, "realtime"))
        self.assertEqual(set(record["services"]["emulator"]), {"instances", "robot", "config", "plant"})
        for name in ("robot_bridge.yaml", "plant.yaml", "robot-robot.yaml"):
            self.assertTrue((config / name).is_file(), name)
        self.assertEqual((config / "calibration-calibration.yaml").read_text(), "name: calibration\n")

    def test_other_plant_can_be_behind_it(self):
        other = self.folder / "other-plant.yaml"
        self.assertEqual(self.scarab("run", *self.words, "--config", f"emulator={other}")[0], 0)
        self.assertEqual(self.command_of("scarab-emulator")["--plant"], str(other))

    def test_other_configuration_of_the_bridge_is_the_emulators_too(self):
        other = self.folder / "other-plant.yaml"
        self.assertEqual(self.scarab("run", *self.words, "--config", f"robot_bridge={other}")[0], 0)
        for name in ("robot-bridge", "emulator"):
            self.assertEqual(self.command_of(f"scarab-{name}")["--config"], str(other))

    def test_its_files_are_checked_before_anything_starts(self):
        self.order("scarab-emulator", "refuse", "plant.yaml:3:1: scene: unknown key")
        code, _, err = self.scarab("run", *self.words)
        self.assertEqual((code, err), (2, "plant.yaml:3:1: scene: unknown key\n"))
        self.assertEqual(self.journal(), [])

    def test_emulator_that_crashes_comes_back_in_the_middle_of_the_trial(self):
        self.order("scarab-experiment", "hold")
        launcher = self.start("run", *self.words)
        wait_until(self.trial_runs, "the trial runs")
        self.order("scarab-emulator", "crash")
        wait_until(lambda: self.journal().count(("start", "scarab-emulator")) == 2, "it is restarted")
        self.withdraw("scarab-experiment", "hold")
        code, out, err = self.finish(launcher)
        self.assertEqual(code, 0, out + err)
        self.assertIn("emulator was killed (signal 9); restart 1 follows", err)

    def test_bridge_that_crashes_fails_the_trial_as_a_plant_does(self):
        self.order("scarab-experiment", "hold")
        launcher = self.start("run", *self.words)
        wait_until(self.trial_runs, "the trial runs")
        self.order("scarab-robot-bridge", "crash")
        code, out, _ = self.finish(launcher)
        self.assertEqual(code, 1)
        self.assertIn("result: failure: robot_bridge was killed", out)
        self.assertEqual(self.journal().count(("start", "scarab-robot-bridge")), 1)

    def test_up_and_status_show_it_beside_the_services(self):
        code, out, err = self.scarab("up", *self.words)
        self.assertEqual(code, 0, err)
        self.assertIn("in real time: logger=1,robot_bridge=1\nemulated hardware: emulator=1\n", out)
        self.order("scarab-status", "document", '{"tick_master": "", "services": []}')
        out = self.scarab("status", *self.words[2:4])[1]
        self.assertRegex(out, r"emulator +\d+ ")
        self.assertIn("robot_bridge/0 says nothing", out)
        self.assertNotIn("emulator/0", out)

    def test_row_of_a_simulated_trial_is_run_with_a_note(self):
        row = {"index": 4, "strategy": "soft+hard", "goal": "across", "height_m": 0.08, "distance_m": 1.46,
               "time_limit_s": 60, "seed": 9, "perturb_position_m": 0.02, "perturb_yaw_rad": 0.05,
               "perturb_friction": 0.1, "friction_scale": 1, "object_mass_kg": 0, "object_diameter_m": 0,
               "perturb_cpg_phase": 1, "configuration": "01234567"}
        file = self.folder / "results.csv"
        file.write_text(",".join(row) + "\n" + ",".join(map(str, row.values())) + "\n")
        code, _, err = self.scarab("run", *self.words, "--row", f"{file}:4")
        self.assertEqual(code, 0, err)
        self.assertIn("the row was run with a simulated plant, which profile 'robot' does not start here", err)
        self.assertEqual(self.command_of("scarab-experiment")["--seed"], "9")

    def test_run_refuses_another_robot_than_that_of_the_stack_that_is_up(self):
        self.assertEqual(self.scarab("up", *self.words)[0], 0)
        for words in (["--driver", "amosii"], ["--device", "/dev/x"], ["--emulated"]):
            code, _, err = self.scarab("run", *self.words[2:4], *words)
            self.assertEqual(code, 2, err)
            self.assertIn(f"{words[0]}: there is a stack up", err)
        self.assertEqual(self.scarab("run", *self.words[2:4])[0], 0)

    def test_killed_keeper_takes_the_emulator_along(self):
        self.order("scarab-experiment", "hold")
        launcher = self.start("run", *self.words)
        wait_until(self.trial_runs, "the trial runs")
        launcher.kill()
        self.finish(launcher)
        wait_until(lambda: self.living() == [], "everything has ended")


class Refusals(RobotCase):
    def test_pace_that_a_robot_does_not_have(self):
        self.assertEqual(self.refused("run", *self.words, "--lockstep"),
                         "--lockstep: robot_bridge goes in real time only. Leave the option out\n")

    def test_device_options_of_a_profile_without_one(self):
        self.assertIn("--emulated: profile 'sim' names no hardware to emulate; with --profile robot",
                      self.refused("run", "--emulated"))
        self.assertIn("--device: profile 'sim' drives no device; with --profile robot",
                      self.refused("up", "--device", "/dev/x"))

    def test_device_that_is_named_and_emulated(self):
        self.assertIn("contradict each other", self.refused("up", *self.words, "--emulated", "--device", "/dev/x"))

    def test_several_emulators(self):
        self.assertIn("there can be just one",
                      self.refused("up", *self.words, "--emulated", "--replicas", "emulator=2"))

    def test_emulator_is_not_there_to_be_configured_without_its_option(self):
        self.assertIn("starts no service 'emulator'",
                      self.refused("up", *self.words, "--config", f"emulator={self.stack_file}"))

    def test_driver_without_a_file(self):
        self.stack_file.write_text(self.stack_file.read_text().replace("driver: amosii", "driver: none"))
        self.assertIn("driver 'none' has no ", self.refused("up", *self.words))

    def test_experiments_on_a_robot(self):
        code, _, err = self.scarab("experiment", "obstacle", "--profile", "robot")
        self.assertEqual(code, 2, err)
        self.assertIn("an experiment's trials are simulated", err)
        self.assertIn("deploy/scarab run --profile robot", err)


class Readiness(RobotCase):
    def setUp(self):
        super().setUp()
        self.configure(self.a_port())

    def test_wait_is_told_of_while_it_lasts(self):
        self.order("scarab-status", "progress", "robot_bridge/0 is not configured: servo 4 does not answer")
        self.order("scarab-status", "hold")
        launcher = self.start("up", *self.words)
        line = launcher.stderr.readline()
        self.assertEqual(line, "scarab: waits: robot_bridge/0 is not configured: servo 4 does not answer\n")
        self.assertIsNone(launcher.poll())
        self.withdraw("scarab-status", "hold")
        self.assertEqual(self.finish(launcher)[0], 0)

    def test_answer_in_the_end_is_told_once(self):
        self.order("scarab-status", "progress", "robot_bridge/0 is missing")
        self.order("scarab-status", "never-ready")
        code, _, err = self.scarab("up", *self.words)
        self.assertEqual(code, 1)
        self.assertRegex(err, r"\Ascarab: waits: robot_bridge/0 is missing\n"
                              r"scarab: the stack is not ready after \d\.\d s:\na table\n"
                              r"scarab-status: premotor is missing\n\Z")

    def test_interrupted_wait_leaves_nothing(self):
        self.order("scarab-status", "hold")
        launcher = self.start("up", *self.words, "--emulated")
        wait_until(lambda: ("start", "scarab-robot-bridge") in self.journal(), "all start")
        os.kill(launcher.pid, signal.SIGINT)
        self.assertEqual(self.finish(launcher)[0], 130)
        self.assertEqual(self.living(), [])


if __name__ == "__main__":
    unittest.main()
