"""`scarab experiment` goes on after an end, and refuses what does not fit."""

import json
import os
import signal
import unittest

from experiment_case import EXPERIMENT, TRIALS, ExperimentTest
from fake_stack import wait_until


class GoesOn(ExperimentTest):
    def stopped_in_the_middle(self, number, *words):
        self.order("scarab-sim", "slow", "0.03")
        self.order("scarab-experiment", "slow", "0.03")
        launcher = self.start_experiment(*words)
        self.wait_for_results(3)
        os.kill(launcher.pid, number)
        ended = self.finish(launcher)
        wait_until(lambda: not self.living(), "everything has ended")
        done = self.journal_indices()
        self.assertLess(len(done), TRIALS)
        return ended, done

    def test_ctrl_c_says_how_to_go_on_and_nothing_is_run_twice(self):
        whole = self.uninterrupted()
        for words in (("--jobs", "2"), ("--stacks", "2")):
            self.out = self.folder / words[0]
            (code, _, err), done = self.stopped_in_the_middle(signal.SIGINT, *words)
            self.assertEqual(code, 130)
            self.assertRegex(err, rf"interrupted after {len(done)} of 12 trials; the same command goes on")
            (self.bin / "trials").unlink()
            code, out, err = self.experiment(*words)
            self.assertEqual(code, 0, err)
            self.assertEqual(sorted(self.trials_run() + done), list(range(TRIALS)))
            self.assertEqual(self.results(), whole)

    def test_killed_launcher_loses_nothing_that_was_done(self):
        whole = self.uninterrupted()
        for words in (("--jobs", "2"), ("--stacks", "2")):
            self.out = self.folder / words[0]
            (code, _, _), done = self.stopped_in_the_middle(signal.SIGKILL, *words)
            self.assertEqual(code, -signal.SIGKILL)
            with open(self.out / "journal.jsonl", "a") as file:
                file.write('{"index": 11, "strat')  # as if it had been killed in the middle of a line
            code, _, err = self.experiment()
            self.assertEqual(code, 0, err)
            self.assertEqual(self.results(), whole)
            sessions = json.loads((self.out / "plan.json").read_text())["sessions"]
            self.assertEqual(sessions[1]["trials"], TRIALS - len(done))

    def test_finished_it_runs_nothing(self):
        whole = self.uninterrupted()
        self.assertEqual(self.experiment()[0], 0)
        (self.bin / "trials").unlink()
        code, out, _ = self.experiment()
        self.assertEqual((code, self.trials_run()), (0, []))
        self.assertIn("12 trials, all of which have been run", out)
        self.assertEqual(self.results(), whole)

    def test_another_plan_is_refused_and_nothing_is_touched(self):
        self.assertEqual(self.experiment()[0], 0)
        before = self.results()
        for words, difference in ((("--trials", "2"), "trials in a cell 3, not 2"),
                                  (("--seed", "7"), "first seed 1000001, not 7"),
                                  (("--shard", "1/2"), "shard none, not 1/2")):
            code, _, err = self.experiment(*words)
            self.assertEqual(code, 2)
            self.assertIn(f"holds another plan: {difference}; --fresh", err)
        self.file.write_text(EXPERIMENT.replace("[0.05, 0.1]", "[0.05, 0.11]"))
        code, _, err = self.experiment()
        self.assertIn("trial 3 with height_m 0.1, not 0.11", err)
        self.assertEqual((code, self.results()), (2, before))

    def test_another_configuration_is_refused_by_its_name(self):
        self.assertEqual(self.experiment()[0], 0)
        self.order("scarab-premotor", "configuration", "tau: 3\n")
        code, _, err = self.experiment()
        self.assertEqual(code, 2)
        self.assertRegex(err, r"was run with another configuration: premotor\.yaml \([0-9a-f]{8}, now ")
        self.assertEqual(self.experiment("--fresh")[0], 0)

    def test_fresh_leaves_what_is_not_its_own(self):
        self.assertEqual(self.experiment()[0], 0)
        (self.out / "notes.txt").write_text("mine")
        code, _, err = self.experiment("--fresh", "--trials", "1")
        self.assertEqual(code, 0, err)
        self.assertEqual((self.out / "notes.txt").read_text(), "mine")
        self.assertEqual(len(self.results().splitlines()), 1 + 4)

    def test_directory_of_something_else_is_refused(self):
        self.out.mkdir()
        (self.out / "thesis.tex").write_text("")
        for words in ((), ("--fresh",)):
            code, _, err = self.experiment(*words)
            self.assertEqual(code, 2)
            self.assertIn("holds thesis.tex, but no plan.json", err)
        self.assertEqual(os.listdir(self.out), ["thesis.tex"])

    def test_two_launchers_do_not_share_a_directory(self):
        self.order("scarab-sim", "hold")
        first = self.start_experiment()
        wait_until(lambda: self.living(), "a worker runs")
        code, _, err = self.experiment()
        self.assertEqual(code, 1)
        self.assertIn("another launcher is at work in", err)
        os.kill(first.pid, signal.SIGTERM)
        self.assertEqual(self.finish(first)[0], 130)


if __name__ == "__main__":
    unittest.main()
