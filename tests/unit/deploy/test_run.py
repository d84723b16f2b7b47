"""`scarab run`: the order of things, and what is left when it ends early."""

import json
import os
import re
import signal
import subprocess
import unittest

from fake_stack import FakeStackTest, wait_until

ORDER = ["scarab-logger", "scarab-plant", "scarab-premotor"]


def services(journal, word):
    return [name for what, name in journal if what == word and name in ORDER]


class Run(FakeStackTest):
    def test_starts_in_order_and_stops_in_reverse_the_logger_last(self):
        code, out, err = self.scarab("run")
        self.assertEqual(code, 0, err)
        log = (self.run_directory() / "logs" / "launcher.log").read_text()
        self.assertEqual(re.findall(r"started service=(\w+)", log), ["logger", "plant", "premotor"])
        self.assertEqual(services(self.journal(), "stop"), ORDER[::-1])
        self.assertIn("result: success", out)
        self.assertEqual(self.living(), [])

    def test_run_directory_holds_what_the_run_was(self):
        self.assertEqual(self.scarab("run")[0], 0)
        directory = self.run_directory()
        self.assertRegex(directory.name, r"^\d{4}-\d{2}-\d{2}-1$")
        for name in ("trial.mcap", "results.csv", "config/plant.yaml", "config/stack.yaml",
                     "config/run.yaml", "logs/plant.log", "logs/launcher.log"):
            self.assertTrue((directory / name).is_file(), name)
        self.assertEqual(list((directory / "pids").glob("*.json")), [])
        self.assertEqual(self.scarab("run")[0], 0)
        self.assertRegex(self.run_directory().name, r"-2$")

    def test_services_get_a_clean_environment_and_their_command_line(self):
        self.assertEqual(self.scarab("run")[0], 0)
        environment = (self.bin / "scarab-plant.environment").read_text().splitlines()
        self.assertNotIn("CYCLONEDDS_URI", environment)
        command = (self.bin / "scarab-logger.command").read_text().splitlines()
        self.assertEqual(command[command.index("--expect") + 1], "logger=1,plant=1,premotor=1")
        self.assertEqual(command[command.index("--run-dir") + 1], str(self.run_directory()))

    def test_failed_trial_is_the_exit_code(self):
        self.order("scarab-experiment", "exit-code", "1")
        self.assertEqual(self.scarab("run")[0], 1)

    def test_configuration_is_checked_before_anything_starts(self):
        self.order("scarab-premotor", "refuse", "beetle.yaml:3:1: tau: unknown key")
        code, _, err = self.scarab("run")
        self.assertEqual((code, err), (2, "beetle.yaml:3:1: tau: unknown key\n"))
        self.assertEqual(self.journal(), [])
        self.assertFalse(self.runs.exists())

    def test_bad_options_start_nothing(self):
        for words in (["--height", "nan"], ["--height", "-1"], ["--trials", "0"], ["--seed", "x"],
                      ["--no-such"], ["--goal", "home"], ["--goal", "across", "--height", "0"],
                      ["--profile", "simm"]):
            code, _, err = self.scarab("run", *words)
            self.assertEqual(code, 2, f"{words}: {err}")
            self.assertNotIn("Traceback", err)
        self.assertEqual(self.journal(), [])
        self.assertFalse(self.runs.exists())

    def test_missing_program_is_named(self):
        (self.bin / "scarab-plant").unlink()
        code, _, err = self.scarab("run")
        self.assertEqual(code, 1)
        self.assertIn("scarab-plant is not built", err)

    def test_place_that_cannot_be_written_is_one_line(self):
        self.runs.mkdir()
        (self.runs / ".stacks").write_text("")
        (self.runs / "latest").mkdir()
        code, _, err = self.scarab("run")
        self.assertEqual(code, 1)
        self.assertEqual(len(err.splitlines()), 1, err)

    def test_service_that_dies_at_the_start_shows_its_log(self):
        self.order("scarab-premotor", "die-at-start")
        code, _, err = self.scarab("run")
        self.assertEqual(code, 1)
        self.assertIn("premotor ended with exit code 1", err)
        self.assertIn("cannot open the device", err)
        self.assertEqual(self.living(), [])

    def test_stack_that_is_not_ready_says_who_is_missing(self):
        self.order("scarab-status", "never-ready")
        code, _, err = self.scarab("run")
        self.assertEqual(code, 1)
        self.assertIn("premotor is missing", err)
        self.assertEqual(self.living(), [])

    def test_deaf_service_is_killed_and_named(self):
        self.be_impatient()
        self.order("scarab-plant", "ignore-term")
        code, _, err = self.scarab("run")
        self.assertEqual(code, 0)
        self.assertIn("plant did not stop within 1 s and was killed", err)
        self.assertEqual(self.living(), [])


class Crash(FakeStackTest):
    def test_crashed_service_is_restarted_and_the_run_goes_on(self):
        self.order("scarab-experiment", "hold")
        launcher = self.start("run")
        wait_until(self.trial_runs, "the trial runs")
        for count in (2, 3):
            self.order("scarab-premotor", "crash")
            wait_until(lambda: services(self.journal(), "start").count("scarab-premotor") == count,
                       "premotor is restarted")
            pid_file = self.run_directory() / "pids" / "premotor.json"
            wait_until(lambda: pid_file.exists() and
                       json.loads(pid_file.read_text())["restarts"] == count - 1,
                       "the restart is counted")
        self.withdraw("scarab-experiment", "hold")
        code, _, err = self.finish(launcher)
        self.assertEqual(code, 0, err)
        self.assertIn("premotor was killed (signal 9); restart 2 follows", err)

    def test_plant_is_not_restarted_in_a_trial(self):
        self.order("scarab-experiment", "hold")
        launcher = self.start("run")
        wait_until(self.trial_runs, "the trial runs")
        self.order("scarab-plant", "crash")
        code, out, _ = self.finish(launcher)
        self.assertEqual(code, 1)
        self.assertIn("result: failure: plant was killed", out)
        self.assertEqual(services(self.journal(), "start").count("scarab-plant"), 1)

    def test_restarted_logger_leaves_the_first_file_alone_and_both_become_logs(self):
        self.order("scarab-experiment", "hold")
        launcher = self.start("run")
        wait_until(self.trial_runs, "the trial runs")
        self.order("scarab-logger", "crash")
        second = self.run_directory() / "trial-2.mcap.active"
        wait_until(second.exists, "the second logger records")
        self.withdraw("scarab-experiment", "hold")
        code, out, err = self.finish(launcher)
        self.assertEqual(code, 0, err)
        self.assertTrue((self.run_directory() / "trial.mcap.active").exists())
        self.assertIn("scarab-log recover made trial.mcap of it", err)
        self.assertRegex(out, r"log: .*/trial\.mcap, trial-2\.mcap\n")


class Interruption(FakeStackTest):
    def interrupt_when(self, condition, what, number=signal.SIGINT, again=False):
        launcher = self.start("run")
        wait_until(condition, what)
        os.kill(launcher.pid, number)
        if again:
            os.kill(launcher.pid, number)
        code, _, err = self.finish(launcher)
        self.assertEqual(code, 130, err)
        self.assertNotIn("Traceback", err)
        self.assertEqual(self.living(), [])

    def log_is_closed(self):
        return ((self.run_directory() / "trial.mcap").exists()
                and not (self.run_directory() / "trial.mcap.active").exists())

    def test_at_moments_all_over_a_run(self):
        for moment in range(14):
            started = len(self.journal())
            launcher = self.start("run")
            try:
                launcher.wait(0.04 * moment)
            except subprocess.TimeoutExpired:
                os.kill(launcher.pid, signal.SIGINT)
            code, _, err = self.finish(launcher)
            if len(self.journal()) > started:  # else the signal may have hit Python's own start
                # -SIGINT: it came while Python itself was ending; a shell shows 130 for it too.
                self.assertIn(code, (130, 0, -signal.SIGINT), err)
                self.assertNotIn("Traceback", err)
            self.assertEqual(self.living(), [])
            self.assertEqual(list(self.runs.glob("*/*.active")), [])

    def test_while_the_stack_gets_ready(self):
        self.order("scarab-status", "hold")
        self.interrupt_when(lambda: ("start", "scarab-premotor") in self.journal(), "all start")

    def test_in_the_trial(self):
        self.order("scarab-experiment", "hold")
        self.interrupt_when(self.trial_runs, "the trial runs")
        self.assertTrue(self.log_is_closed())
        self.assertEqual(services(self.journal(), "stop"), ORDER[::-1])

    def test_twice(self):
        self.order("scarab-experiment", "hold")
        self.interrupt_when(self.trial_runs, "the trial runs", again=True)
        self.assertTrue(self.log_is_closed())

    def test_second_one_during_a_slow_shutdown(self):
        self.order("scarab-experiment", "hold")
        self.be_impatient()
        self.order("scarab-plant", "ignore-term")
        launcher = self.start("run")
        wait_until(self.trial_runs, "the trial runs")
        os.kill(launcher.pid, signal.SIGINT)
        wait_until(lambda: ("stop", "scarab-premotor") in self.journal(), "premotor has stopped")
        os.kill(launcher.pid, signal.SIGINT)
        self.assertEqual(self.finish(launcher)[0], 130)
        self.assertEqual(self.living(), [])
        self.assertTrue(self.log_is_closed())

    def test_by_sigterm_and_by_a_closed_terminal(self):
        self.order("scarab-experiment", "hold")
        for number in (signal.SIGTERM, signal.SIGHUP):
            self.interrupt_when(self.trial_runs, "the trial runs", number)
            self.assertTrue(self.log_is_closed())

    def test_killed_launcher_leaves_no_process_either(self):
        self.order("scarab-experiment", "hold")
        launcher = self.start("run")
        wait_until(self.trial_runs, "the trial runs")
        launcher.kill()
        self.finish(launcher)
        wait_until(lambda: self.living() == [], "everything has ended")
        wait_until(self.log_is_closed, "the log is closed")


if __name__ == "__main__":
    unittest.main()
