"""`scarab experiment`: who runs what, what is kept, and how it goes on after an end."""

import json
import os
import signal
import unittest

from experiment_case import EXPERIMENT, TRIALS, ExperimentTest
from fake_stack import wait_until


class Runs(ExperimentTest):
    def test_every_trial_is_run_once_and_a_failed_trial_is_a_result(self):
        code, out, err = self.experiment("--jobs", "3")
        self.assertEqual(code, 0, err)
        self.assertEqual(sorted(self.trials_run()), list(range(TRIALS)))
        lines = self.results().splitlines()
        self.assertEqual([line.split(",")[0] for line in lines],
                         ["index", *map(str, range(TRIALS))])
        self.assertIn(",0,60,time is up,", lines[4])
        self.assertRegex(out, r"soft\+hard +3/3 +0/3")
        self.assertEqual(self.living(), [])

    def test_what_is_kept_says_what_was_run(self):
        self.assertEqual(self.experiment()[0], 0)
        plan = json.loads((self.out / "plan.json").read_text())
        self.assertEqual((plan["name"], plan["figure"], len(plan["trials"])), ("tiny", "obstacle", TRIALS))
        self.assertRegex(plan["configuration"], r"^[0-9a-f]{8}$")
        self.assertIn("--inproc", plan["command"])
        self.assertEqual([s["trials"] for s in plan["sessions"]], [TRIALS])
        for name in ("robot", "plant", "premotor", "supervisor"):
            self.assertTrue((self.out / "config" / f"{name}.yaml").is_file(), name)
        for line in self.results().splitlines()[1:]:
            self.assertTrue(line.endswith(f",{plan['configuration']}"))

    def test_worker_reads_the_files_that_are_kept(self):
        self.assertEqual(self.experiment()[0], 0)
        command = self.command_of("scarab-sim")
        self.assertEqual(command["--plant"], str(self.out / "config" / "plant.yaml"))

    def test_stacks_give_the_same_bytes_and_have_no_logger(self):
        whole = self.uninterrupted()
        code, _, err = self.experiment("--stacks", "2")
        self.assertEqual(code, 0, err)
        self.assertEqual(self.results(), whole)
        started = [name for what, name in self.journal() if what == "start"]
        self.assertEqual(started.count("scarab-plant"), 2)
        self.assertNotIn("scarab-logger", started)
        self.assertEqual(self.living(), [])

    def test_recorded_trials_have_a_log_each(self):
        self.file.write_text(EXPERIMENT.replace("trials: 3", "trials: 1\nrecord: true"))
        for out, words in (("a", ("--jobs", "2")), ("b", ("--stacks", "2"))):
            self.out = self.folder / out
            code, _, err = self.experiment(*words)
            self.assertEqual(code, 0, err)
            self.assertEqual(sorted(file.name for file in self.out.glob("*.mcap*")),
                             [f"trial-{n}.mcap" for n in range(4)])
        self.assertEqual(self.living(), [])

    def test_dead_worker_is_replaced_and_its_trial_run_again(self):
        whole = self.uninterrupted()
        for word in ("die", "error", "nonsense"):
            self.order("scarab-sim", word, "2")
            self.out = self.folder / word
            code, _, err = self.experiment("--jobs", "2")
            self.assertEqual(code, 0, err)
            self.assertIn("retry 1 of 2", err)
            self.assertEqual(self.results(), whole)

    def test_trial_that_can_never_be_run_ends_it_and_the_rest_is_kept(self):
        whole = self.uninterrupted()
        started = len(self.journal())
        self.order("scarab-sim", "error", "100")
        code, _, err = self.experiment("--jobs", "1")
        self.assertEqual(code, 1)
        self.assertRegex(err, r"trial 0 could not be run in 3 attempts; .*plant is silent")
        self.assertEqual(len(self.journal()), started + 3)
        self.withdraw("scarab-sim", "error")
        self.assertEqual(self.experiment()[0], 0)
        self.assertEqual(self.results(), whole)

    def test_worker_that_takes_no_trials_is_not_tried_again(self):
        self.order("scarab-sim", "refuse-trials", "unknown key 'indx'")
        code, _, err = self.experiment("--jobs", "1")
        self.assertEqual(code, 1)
        self.assertIn("unknown key 'indx'", err)
        self.assertNotIn("retry", err)

    def test_plant_that_dies_costs_its_stack_but_no_trial(self):
        whole = self.uninterrupted()
        self.order("scarab-experiment", "slow", "0.02")
        launcher = self.start_experiment("--stacks", "1")
        self.wait_for_results(2)
        self.order("scarab-plant", "crash")
        code, _, err = self.finish(launcher)
        self.assertEqual(code, 0, err)
        self.assertIn("plant was killed (signal 9)", err)
        self.assertEqual(self.results(), whole)
        self.assertEqual(self.living(), [])


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
        self.assertIn("all 12 trials have been run", out)
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


class Shards(ExperimentTest):
    def shard(self, i, n):
        out = self.folder / f"shard-{i}"
        code, _, err = self.scarab("experiment", str(self.file), "--shard", f"{i}/{n}", "--out", str(out))
        self.assertEqual(code, 0, err)
        return str(out)

    def merge(self, *directories):
        return self.scarab("experiment", "merge", *directories, "--no-report", "--out", str(self.out))

    def test_merged_they_are_as_if_run_at_once(self):
        whole = self.uninterrupted()
        shards = [self.shard(i, 3) for i in range(1, 4)]
        code, out, err = self.merge(*reversed(shards))
        self.assertEqual(code, 0, err)
        self.assertEqual(self.results(), whole)
        self.assertIn("12 trials of 3 shards", out)
        (self.bin / "trials").unlink()
        self.assertEqual(self.experiment()[0], 0)  # there is nothing left to run
        self.assertEqual(self.trials_run(), [])
        code, _, err = self.merge(*shards)
        self.assertEqual(code, 2)
        self.assertIn("holds an experiment already", err)

    def test_what_is_missing_or_doubled_is_named(self):
        one, two, _ = (self.shard(i, 3) for i in range(1, 4))
        for directories, said in (((one, two), "shard 3/3 missing"), ((one,), "shards 2/3, 3/3 missing"),
                                  ((one, two, one), "are both shard 1/3"),
                                  ((str(self.folder),), "has no plan.json")):
            code, _, err = self.merge(*directories)
            self.assertEqual(code, 2)
            self.assertIn(said, err)
        self.assertFalse(self.out.exists())

    def test_what_does_not_belong_together_is_named(self):
        shards = [self.shard(i, 3) for i in range(1, 3)]
        journal = self.folder / "shard-2" / "journal.jsonl"
        text = journal.read_text()
        journal.write_text("".join(text.splitlines(True)[:-1]))
        third = self.shard(3, 3)
        self.assertIn("is not finished: 3 of 4 trials", self.merge(*shards, third)[2])
        journal.write_text(text)
        self.order("scarab-plant", "configuration", "mass: 3\n")
        self.scarab("experiment", str(self.file), "--shard", "3/3", "--out", third, "--fresh")
        self.assertIn("was run with configuration", self.merge(*shards, third)[2])
        self.file.write_text(EXPERIMENT.replace("time_limit_s: 60", "time_limit_s: 50"))
        self.scarab("experiment", str(self.file), "--shard", "3/3", "--out", third, "--fresh")
        self.assertIn("trial 0 with time_limit_s 50, not 60", self.merge(*shards, third)[2])


class Words(ExperimentTest):
    def test_bad_words_start_nothing(self):
        for words, said in ((["obstackle"], "did you mean 'obstacle'?"), (["lits"], "did you mean 'list'?"),
                            (["obstacle", "--shard", "3/2"], "there is no shard 3 of 2"),
                            (["obstacle", "--shard", "half"], "'half' is not I/N"),
                            (["obstacle", "--stacks", "2", "--inproc"], "not allowed with"),
                            (["obstacle", "--stacks", "2", "--jobs", "2"], "--jobs is of --inproc"),
                            (["obstacle", "else"], "unknown argument 'else'"),
                            (["obstacle", "--trails", "3"], "did you mean '--trials'?"),
                            (["merge"], "needs the directories"), (["merge", "x", "--seed", "3"], "is not for merge"),
                            ([str(self.folder / "no.yaml")], "there is no file"),
                            ([str(self.file), "--seed", str(2**64 - 1)], "need seeds above"),
                            ([str(self.file), "--robot", "betle"], "did you mean 'beetle'?")):
            code, _, err = self.scarab("experiment", *words)
            self.assertEqual(code, 2, f"{words}: {err}")
            self.assertIn(said, err)
            self.assertEqual(len(err.splitlines()), 1, err)
        self.assertEqual(self.journal(), [])
        self.assertFalse(self.runs.exists())

    def test_strategy_that_the_supervisor_does_not_know(self):
        self.file.write_text(EXPERIMENT.replace("soft+hard]", "soft+hrad]"))
        code, _, err = self.experiment()
        self.assertEqual(code, 2)
        self.assertIn("experiment tiny: unknown strategy 'soft+hrad' (did you mean 'soft+hard'?)", err)
        self.assertFalse(self.out.exists())

    def test_service_that_refuses_its_file(self):
        self.order("scarab-premotor", "refuse", "beetle.yaml:3:1: tau: unknown key")
        code, _, err = self.experiment()
        self.assertEqual((code, err), (2, "beetle.yaml:3:1: tau: unknown key\n"))
        self.assertFalse(self.out.exists())

    def test_dry_run_shows_cells_and_size(self):
        code, out, _ = self.experiment("--dry-run", "--shard", "2/5")
        self.assertEqual(code, 0)
        self.assertIn("4 cells x 3 trials = 12 trials, of which shard 2/5 has 3", out)
        self.assertRegex(out, r"\n +9-11  soft\+hard, height_m 0\.1\b")
        self.assertFalse(self.out.exists())
        self.assertEqual(self.journal(), [])

    def test_missing_program_is_named(self):
        (self.bin / "scarab-sim").unlink()
        code, _, err = self.experiment()
        self.assertEqual(code, 1)
        self.assertIn("scarab-sim is not built", err)

    def test_progress_in_a_file_is_whole_lines(self):
        _, _, err = self.experiment()
        for line in err.splitlines():
            self.assertRegex(line, r"^tiny \[[= ]{24}\] \d+/12, \d+ succeeded")
        self.assertIn("] 12/12, 6 succeeded", err)


if __name__ == "__main__":
    unittest.main()
