"""`scarab experiment`: who runs what, and what is kept."""

import json
import unittest

from experiment_case import EXPERIMENT, TRIALS, ExperimentTest


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
        self.assertEqual(self.command_of("scarab-logger")["--config"], str(self.folder / "any.yaml"))
        self.assertEqual(self.command_of("scarab-plant")["--config"], str(self.out / "config" / "plant.yaml"))
        self.assertEqual(self.living(), [])

    def test_trial_whose_log_is_split_is_refused_with_the_reason(self):
        self.file.write_text(EXPERIMENT.replace("trials: 3", "trials: 1\nrecord: true"))
        self.order("scarab-logger", "files", "3")
        code, _, err = self.experiment("--stacks", "1")
        self.assertEqual(code, 1)
        self.assertRegex(err, r"left 3 files in .*: an experiment's trial is one file")
        self.assertEqual(list(self.out.glob("*.mcap*")), [])

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
        self.order("scarab-sim", "error", "100")
        code, _, err = self.experiment("--jobs", "1")
        self.assertEqual(code, 1)
        self.assertRegex(err, r"trial 0 could not be run in 3 attempts; .*plant is silent")
        self.assertEqual(self.journal(), [("start", "scarab-sim")] * 3)
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

    def test_without_a_wish_results_lie_in_runs_by_their_name(self):
        code, out, err = self.scarab("experiment", str(self.file), "--no-report", "--trials", "1")
        self.assertEqual(code, 0, err)
        self.assertTrue((self.runs / "experiments" / "tiny" / "results.csv").is_file())
        code, out, err = self.scarab("experiment", str(self.file), "--shard", "2/3", "--trials", "1")
        self.assertEqual(code, 0, err)
        self.assertTrue((self.runs / "experiments" / "tiny-shard-2-of-3" / "results.csv").is_file())

    def test_report_that_cannot_be_drawn_is_a_failure_and_the_results_are_whole(self):
        self.assertEqual(self.experiment()[0], 0)
        before = self.results()
        (self.out / "summary.json").mkdir()
        code, _, err = self.scarab("experiment", str(self.file), "--out", str(self.out))
        self.assertEqual(code, 1)
        self.assertRegex(err, r"the report of \S+ could not be drawn: .*The results are whole")
        self.assertEqual(self.results(), before)

    def test_progress_in_a_file_is_whole_lines(self):
        _, _, err = self.experiment()
        for line in err.splitlines():
            self.assertRegex(line, r"^tiny \[[= ]{24}\] \d+/12, \d+ succeeded")
        self.assertIn("] 12/12, 6 succeeded", err)


if __name__ == "__main__":
    unittest.main()
