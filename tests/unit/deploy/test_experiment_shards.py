"""`scarab experiment --shard` and `merge`."""

import unittest

from experiment_case import EXPERIMENT, ExperimentTest


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
        code, _, err = self.scarab("experiment", "merge", one, two, "--fresh", "--out", one)
        self.assertEqual(code, 2)
        self.assertIn("is one of the shards", err)
        self.assertEqual(len(self.results(self.folder / "shard-1").splitlines()), 1 + 4)

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


if __name__ == "__main__":
    unittest.main()
