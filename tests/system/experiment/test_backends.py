#!/usr/bin/python3
"""The same trials in process and on stacks side by side; what is recorded of them; shards."""

import csv
import subprocess
import unittest

from case import BIN, EXPERIMENT, IN_PROCESS, ON_STACKS, SCARAB, TRIALS, ExperimentCase, table


class Backends(ExperimentCase):
    def test_results_are_the_same_bytes_whoever_runs_the_trials(self):
        in_process = self.run_into("in-process", *IN_PROCESS)
        on_stacks = self.run_into("on-stacks", *ON_STACKS)
        self.assertEqual(table(in_process), table(on_stacks))
        rows = list(csv.DictReader(table(in_process).decode().splitlines()))
        self.assertEqual([int(row["index"]) for row in rows], list(range(TRIALS)))
        self.assertEqual({row["success"] for row in rows}, {"0", "1"})
        self.again_with_its_options(in_process, next(row for row in rows if row["success"] == "1"))
        shards = [self.run_into(f"shard-{i}", "--shard", f"{i}/3") for i in (1, 2, 3)]
        self.experiment("merge", *map(str, shards), "--no-report", "--out", str(self.folder / "merged"))
        self.assertEqual(table(self.folder / "merged"), table(in_process))

    def again_with_its_options(self, directory, row):
        """The trial of one row, as a person would look at it."""
        again = self.folder / "again.csv"
        place = f"{directory / 'results.csv'}:{row['index']}"
        subprocess.run([str(SCARAB), "sim", "--row", place, "--bin", str(BIN), "--output",
                        str(self.folder / "again.mcap"), "--results", str(again), "--quiet"],
                       check=True, capture_output=True)
        with open(again, newline="") as file:
            found = next(csv.DictReader(file))
        self.assertEqual([found[key] for key in ("strategy", "seed", "success", "reason")],
                         [row[key] for key in ("strategy", "seed", "success", "reason")])
        self.assertEqual(float(found["time_s"]), float(row["time_s"]))

    def test_recorded_trials_have_the_same_samples_and_a_report_is_drawn(self):
        self.file.write_text(EXPERIMENT.replace("[0.1, 9.0]", "[0.1]").replace("trials: 4", "trials: 1\nrecord: true"))
        in_process = self.run_into("in-process", *IN_PROCESS)
        on_stacks = self.run_into("on-stacks", *ON_STACKS)
        self.assertEqual(table(in_process), table(on_stacks))
        for name in ("trial-0.mcap", "trial-1.mcap"):
            subprocess.run([str(BIN / "scarab-log"), "diff", str(in_process / name), str(on_stacks / name)],
                           check=True, capture_output=True)
        out = self.experiment(str(self.file), "--out", str(in_process))  # nothing is left but to draw it
        self.assertIn("2 trials, all of which have been run", out)
        for name in ("report.html", "summary.json", "tiny.svg", "tiny.png"):
            self.assertGreater((in_process / name).stat().st_size, 0, name)


if __name__ == "__main__":
    unittest.main()
