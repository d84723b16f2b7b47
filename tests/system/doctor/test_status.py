"""`scarab status` of real stacks: rates, timing, restarts, and who waits for whom."""

import json
import os
import signal
import subprocess

import case
from case import DOMAIN, DoctorCase, wait_until


class Status(DoctorCase):
    def status(self):
        """(whether all is well, the one stack)"""
        done = self.scarab("status", "--json")
        document = json.loads(done.stdout)
        self.assertEqual(document["healthy"], done.returncode == 0)
        (stack,) = document["stacks"]
        return document["healthy"], stack

    def process(self, name):
        return next(p for p in self.status()[1]["processes"] if p["name"] == name)

    def a_trial_runs(self):
        """Until the end of the test."""
        trial = subprocess.Popen(self.command("run", "--goal", "none", "--time-limit", "36000"),
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 env=self.environment)
        self.addCleanup(trial.wait, case.PATIENCE_S)
        self.addCleanup(trial.terminate)
        wait_until(lambda: (self.status()[1]["tick"] or 0) > 0, "the trial runs")

    def test_idle_stack_is_well(self):
        self.up()
        healthy, stack = self.status()
        self.assertTrue(healthy, stack)
        self.assertEqual([p["name"] for p in stack["processes"]],
                         ["keeper", "logger", "plant", "supervisor", "premotor"])
        self.assertEqual({p["lifecycle"] for p in stack["processes"][1:]}, {"inactive"})
        self.assertEqual((stack["domain"], stack["tick_master"], stack["trial"]),
                         (DOMAIN, "plant/0", 0))

    def test_real_time_shows_its_pace_and_its_timing(self):
        self.up()
        self.a_trial_runs()
        stack = self.status()[1]
        self.assertEqual(stack["pace"], "realtime")
        self.assertAlmostEqual(stack["real_time_factor"], 1.0, delta=0.25)
        self.assertAlmostEqual(stack["ticks_per_s"], 10 * stack["real_time_factor"], delta=0.5)
        timing = next(p for p in stack["processes"] if p["name"] == "plant")["histograms"]
        self.assertEqual(set(timing), {"command_age", "tick_cycle", "tick_jitter", "tick_overrun"})
        for name, values in timing.items():
            if name != "tick_overrun":  # there may have been none
                self.assertGreater(values["count"], 0)
            self.assertLessEqual(values["p50_s"], values["p99_s"])
            self.assertLessEqual(values["p99_s"], values["max_s"])

    def test_crash_is_counted(self):
        self.up()
        os.kill(self.process("premotor")["pid"], signal.SIGKILL)
        wait_until(lambda: self.process("premotor")["restarts"] == 1, "it is restarted")

    def test_stopped_service_is_waited_for_by_name(self):
        self.up("--lockstep")
        self.a_trial_runs()
        premotor = self.process("premotor")["pid"]
        os.kill(premotor, signal.SIGSTOP)
        self.addCleanup(os.kill, premotor, signal.SIGCONT)
        wait_until(lambda: self.status()[1]["waits"], "somebody waits")
        healthy, stack = self.status()
        self.assertFalse(healthy)
        self.assertRegex(stack["waits"][0], "^plant/0 waits for premotor/0")
        self.assertIn(stack["waits"][0], stack["troubles"])


if __name__ == "__main__":
    case.main()
