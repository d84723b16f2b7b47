"""`scarab up`, `down`, `status`, `logs`: a stack that lasts."""

import json
import os
import signal
import unittest

from fake_stack import FakeStackTest, wait_until
from launcher.process_identity import ProcessIdentity


class Up(FakeStackTest):
    domain = 0

    def setUp(self):
        super().setUp()
        Up.domain += 1
        self.words = ("--domain", str(150 + Up.domain))

    def keeper(self):
        file = self.runs / ".stacks" / f"domain-{self.words[1]}.json"
        return json.loads(file.read_text())["keeper"]["pid"]

    def up(self):
        code, out, err = self.scarab("up", *self.words)
        self.assertEqual(code, 0, out + err)

    def test_up_status_run_down(self):
        self.up()
        self.assertEqual(len(self.living()), 3)
        code, out, _ = self.scarab("status", *self.words)
        self.assertEqual(code, 0, out)
        code, out, err = self.scarab("run", *self.words)
        self.assertEqual(code, 0, err)
        self.assertIn("that is up", out)
        self.assertEqual(len(self.living()), 3)
        self.assertEqual(self.scarab("down", *self.words)[0], 0)
        self.assertEqual(self.living(), [])
        self.assertEqual(self.scarab("status", *self.words)[0], 1)
        self.assertIn("a line of scarab-plant", self.scarab("logs", "plant", *self.words)[1])

    def test_down_without_a_stack_is_no_error(self):
        code, out, _ = self.scarab("down", *self.words)
        self.assertEqual((code, out), (0, "no stack is running\n"))

    def test_second_up_refuses(self):
        self.up()
        code, _, err = self.scarab("up", *self.words)
        self.assertEqual(code, 1)
        self.assertIn(f"DDS domain {self.words[1]} is in use", err)
        self.assertEqual(len(self.living()), 3)

    def test_one_of_two_at_the_same_time_refuses(self):
        both = [self.start("up", *self.words) for _ in range(2)]
        codes = sorted(self.finish(launcher)[0] for launcher in both)
        self.assertEqual(codes, [0, 1])
        self.assertEqual(len(self.living()), 3)

    def test_interrupted_up_leaves_nothing(self):
        self.order("scarab-status", "hold")
        launcher = self.start("up", *self.words)
        wait_until(lambda: len(self.living()) == 3, "all run")
        os.kill(launcher.pid, signal.SIGINT)
        self.assertEqual(self.finish(launcher)[0], 130)
        self.assertEqual(self.living(), [])

    def test_plant_that_crashes_between_trials_is_restarted(self):
        self.up()
        before = self.journal().count(("start", "scarab-plant"))
        self.order("scarab-plant", "crash")
        wait_until(lambda: self.journal().count(("start", "scarab-plant")) == before + 1,
                   "the plant is restarted")

    def test_status_notices_a_dead_process(self):
        self.stack_file.write_text(self.stack_file.read_text().replace(
            "premotor: {binary: scarab-premotor, instances: 1, restart: always",
            "premotor: {binary: scarab-premotor, instances: 1, restart: never"))
        self.up()
        self.order("scarab-premotor", "crash")
        wait_until(lambda: len(self.living()) == 2, "premotor is dead")
        wait_until(lambda: not (self.run_directory() / "pids" / "premotor.json").exists(), "noticed")
        code, out, _ = self.scarab("status", *self.words)
        self.assertEqual(code, 1)
        self.assertRegex(out, r"premotor +NOT RUNNING")

    def test_killed_keeper_takes_its_services_along_and_its_domain_is_free_again(self):
        self.up()
        os.kill(self.keeper(), signal.SIGKILL)
        wait_until(lambda: self.living() == [], "the services have ended")
        self.assertEqual(self.scarab("status", *self.words)[0], 1)
        self.up()

    def test_second_series_of_trials_on_one_stack_refuses(self):
        self.up()
        self.order("scarab-experiment", "hold")
        first = self.start("run", *self.words)
        wait_until(self.trial_runs, "the trial runs")
        code, _, err = self.scarab("run", *self.words)
        self.assertEqual(code, 1)
        self.assertIn("trials are already running", err)
        self.assertEqual(len(list(self.runs.glob("2*"))), 2)  # the stack's and the first run's
        self.withdraw("scarab-experiment", "hold")
        self.assertEqual(self.finish(first)[0], 0)

    def test_interrupted_run_leaves_the_lasting_stack_alone(self):
        self.up()
        self.order("scarab-experiment", "hold")
        launcher = self.start("run", *self.words)
        wait_until(self.trial_runs, "the trial runs")
        os.kill(launcher.pid, signal.SIGINT)
        self.assertEqual(self.finish(launcher)[0], 130)
        self.assertEqual(len(self.living()), 3)

    def test_run_that_keeps_its_stack(self):
        code, out, err = self.scarab("run", "--keep", *self.words)
        self.assertEqual(code, 0, err)
        self.assertIn("still running", out)
        self.assertEqual(len(self.living()), 3)

    def test_logs_of_one_service_and_of_an_unknown_one(self):
        self.up()
        self.assertIn("a line of scarab-plant", self.scarab("logs", "plant", *self.words)[1])
        code, _, err = self.scarab("logs", "plan", *self.words)
        self.assertEqual(code, 2)
        self.assertIn("did you mean 'plant'?", err)


class PidReuse(FakeStackTest):
    def test_leftover_pid_file_of_a_recycled_pid_kills_nobody(self):
        mine = ProcessIdentity.of(os.getpid())
        recycled = ProcessIdentity(mine.pid, mine.start_ticks - 1, mine.boot_id)
        stale = self.runs / "2026-01-01-1"
        (stale / "pids").mkdir(parents=True)
        (stale / "pids" / "plant.json").write_text(json.dumps(recycled.to_json()))
        (self.runs / ".stacks").mkdir()
        (self.runs / ".stacks" / "domain-199.json").write_text(json.dumps({
            "kind": "lasting", "keeper": recycled.to_json(), "domain": 199, "interface": "lo",
            "tag": "", "peers": [], "directory": str(stale), "expected": "plant=1", "here": "plant=1",
            "pace": "realtime", "tick_master": "plant", "ready": True}))
        signals = []
        for number in (signal.SIGTERM, signal.SIGUSR1):
            previous = signal.signal(number, lambda *_: signals.append(1))
            self.addCleanup(signal.signal, number, previous)
        code, out, _ = self.scarab("down", "--domain", "199")
        self.assertEqual((code, out), (0, "no stack is running\n"))
        self.assertEqual(signals, [])
        self.assertFalse((stale / "pids" / "plant.json").exists())

    def test_identity_of_another_start_time_is_not_signalled(self):
        mine = ProcessIdentity.of(os.getpid())
        other = ProcessIdentity(mine.pid, mine.start_ticks + 1, mine.boot_id)
        self.assertTrue(mine.alive())
        self.assertFalse(other.alive())
        self.assertFalse(other.signal(signal.SIGKILL))  # or this test would be gone
        self.assertTrue(other.wait_end(0))

    def test_dead_process_has_no_identity(self):
        child = os.fork()
        if child == 0:
            os._exit(0)
        os.waitpid(child, 0)
        self.assertIsNone(ProcessIdentity.of(child))


if __name__ == "__main__":
    unittest.main()
