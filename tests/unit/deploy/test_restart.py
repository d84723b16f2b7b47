"""Crashes: who is restarted, what a trial hears of it, and what is known of a service that crashes on and on."""

import json
import os
import signal
import time
import unittest

from fake_stack import FakeStackTest, wait_until
from launcher.back_off import LOOP_AFTER
from launcher.crash_record import CrashRecord
from launcher.run_directory import RunDirectory


class Restart(FakeStackTest):
    domain = 140

    def setUp(self):
        super().setUp()
        Restart.domain += 1
        self.words = ("--domain", str(Restart.domain))

    def up(self, *words):
        code, out, err = self.scarab("up", *self.words, *words)
        self.assertEqual(code, 0, out + err)
        self.stack_directory = self.run_directory()

    def pid_of(self, process):
        file = self.stack_directory / "pids" / f"{process}.json"
        wait_until(file.exists, f"{process} runs")
        return json.loads(file.read_text())["pid"]

    def crashes_of(self, process):
        return CrashRecord.read(RunDirectory(self.stack_directory), process)

    def kill(self, process):
        pid = self.pid_of(process)
        os.kill(pid, signal.SIGKILL)
        wait_until(lambda: self.pid_of(process) != pid, f"{process} is restarted")

    def test_plant_killed_in_a_trial_fails_it_at_once_in_both_kinds_of_run(self):
        self.order("scarab-experiment", "hold")
        for lasting in (True, False):
            with self.subTest(lasting=lasting):
                if lasting:
                    self.up("--lockstep")
                launcher = self.start("run", *self.words)
                wait_until(self.trial_runs, "the trial runs")
                if not lasting:
                    self.stack_directory = self.run_directory()
                killed = time.monotonic()
                os.kill(self.pid_of("plant"), signal.SIGKILL)
                wait_until(lambda: not self.trial_runs(), "the trial has ended")
                self.assertLess(time.monotonic() - killed, 2.0)
                code, out, err = self.finish(launcher)
                self.assertEqual(code, 1)
                self.assertIn("result: failure: plant was killed (signal 9)", out)
                self.assertIn("plant was killed (signal 9) in the middle of a trial", err)
                self.assertFalse((self.run_directory() / ".fault").exists())
                if lasting:
                    self.withdraw("scarab-experiment", "hold")
                    self.pid_of("plant")  # between trials it comes again
                    code, _, err = self.scarab("run", *self.words)
                    self.assertEqual((code, self.crashes_of("plant").restarts), (0, 1), err)
                    self.scarab("down", *self.words)
                    self.order("scarab-experiment", "hold")

    def test_run_on_a_stack_that_is_up_tells_of_crashes_too(self):
        self.up()
        self.order("scarab-experiment", "hold")
        launcher = self.start("run", *self.words)
        wait_until(self.trial_runs, "the trial runs")
        self.kill("premotor")
        self.withdraw("scarab-experiment", "hold")
        code, _, err = self.finish(launcher)
        self.assertEqual(code, 0, err)
        self.assertIn("premotor was killed (signal 9); restart 1 follows", err)

    def test_run_ends_with_the_keeper_of_the_stack_it_uses(self):
        self.up()
        self.order("scarab-experiment", "hold")
        launcher = self.start("run", *self.words)
        wait_until(self.trial_runs, "the trial runs")
        self.assertEqual(self.scarab("down", *self.words)[0], 0)
        code, _, err = self.finish(launcher)
        self.assertEqual(code, 1)
        self.assertIn("the stack was stopped in the middle of the run", err)

    def test_crashes_are_counted_and_named(self):
        self.up()
        self.assertEqual(self.crashes_of("premotor"), CrashRecord())
        for count in (1, 2):
            self.kill("premotor")
            self.assertEqual(self.crashes_of("premotor"),
                             CrashRecord(count, count, False, "was killed (signal 9)"))
        self.assertEqual(self.crashes_of("plant").restarts, 0)

    def test_crash_loop_is_reported_once_and_forgotten_after_a_good_run(self):
        self.stack_file.write_text(self.stack_file.read_text().replace("forget_s: 30", "forget_s: 2"))
        self.up()
        for _ in range(LOOP_AFTER):
            self.assertFalse(self.crashes_of("premotor").looping)
            self.kill("premotor")
        self.assertTrue(self.crashes_of("premotor").looping)
        log = (self.stack_directory / "logs" / "launcher.log").read_text()
        self.assertEqual(log.count("looping service=premotor"), 1)
        wait_until(lambda: not self.crashes_of("premotor").looping, "the crashes are forgotten")
        self.assertEqual(self.crashes_of("premotor").restarts, LOOP_AFTER)

    def test_stack_outlives_a_disk_that_takes_no_more(self):
        self.up()
        pid = self.pid_of("premotor")
        (self.stack_directory / "logs" / "events.jsonl").unlink()
        for name in ("logs/events.jsonl", "pids/premotor.json.new", "pids/premotor.crashes.new"):
            (self.stack_directory / name).mkdir()  # what is written there fails from here on
        os.kill(pid, signal.SIGKILL)
        starts = [("start", "scarab-premotor")] * 2
        wait_until(lambda: [j for j in self.journal() if j == starts[0]] == starts,
                   "it is restarted")
        self.assertEqual(len(self.living()), 3)

    def test_program_that_is_gone_is_tried_again_until_it_is_back(self):
        self.up()
        program, aside = self.bin / "scarab-premotor", self.bin / "aside"
        pid = self.pid_of("premotor")
        program.rename(aside)
        os.kill(pid, signal.SIGKILL)
        events = self.stack_directory / "logs" / "events.jsonl"
        wait_until(lambda: "unstartable" in events.read_text(), "it cannot be started")
        aside.rename(program)
        wait_until(lambda: self.pid_of("premotor") != pid, "it is restarted")


if __name__ == "__main__":
    unittest.main()
