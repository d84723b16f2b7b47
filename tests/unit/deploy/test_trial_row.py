"""`--row FILE:N` of `scarab run` and `scarab sim`: a row of results becomes the options of its trial."""

import unittest

from experiment_case import ExperimentTest
from launcher.trial_options import PARSERS


class Rows(ExperimentTest):
    def setUp(self):
        super().setUp()
        self.assertEqual(self.experiment("--trials", "2")[0], 0)
        self.table = self.out / "results.csv"

    def sim(self, row, *words):
        code, _, err = self.scarab("sim", "--row", row, *words)
        return code, err

    def test_row_gives_every_option_of_its_trial(self):
        code, err = self.sim(f"{self.table}:5")
        self.assertEqual((code, err), (0, ""))
        given = self.command_of("scarab-sim")
        wanted = {"--strategy": "soft+hard", "--height": "0.05", "--goal": "across", "--distance": "1.46",
                  "--seed": "1000002", "--time-limit": "60.0", "--perturb-position": "0.02",
                  "--perturb-yaw": "0.05", "--perturb-friction": "0.1", "--friction-scale": "1.0",
                  "--object-mass": "0.0", "--object-diameter": "0.0"}
        self.assertEqual({option: given.get(option) for option in wanted}, wanted)
        self.assertNotIn("--no-perturbation", given)
        self.assertEqual(len(wanted), len(PARSERS) - 1)  # all but --trials

    def test_option_beside_it_changes_the_trial(self):
        self.assertEqual(self.sim(f"{self.table}:5", "--height", "0.12", "--seed=4")[0], 0)
        given = self.command_of("scarab-sim")
        self.assertEqual((given["--height"], given["--seed"], given["--strategy"]), ("0.12", "4", "soft+hard"))

    def test_run_takes_it_too(self):
        code, _, err = self.scarab("run", "--no-figure", "--row", f"{self.table}:2")
        self.assertEqual(code, 0, err)
        given = self.command_of("scarab-experiment")
        self.assertEqual((given["--height"], given["--seed"]), ("0.1", "1000001"))

    def test_trial_without_perturbation_stays_so(self):
        lines = self.table.read_text().replace(",0.02,0.05,0.1,True,", ",0,0,0,0,").replace(
            ",0.02,0.05,0.1,1,", ",0,0,0,0,")
        self.table.write_text(lines)
        self.assertEqual(self.sim(f"{self.table}:5")[0], 0)
        self.assertIn("--no-perturbation", (self.bin / "scarab-sim.command").read_text())

    def test_other_configuration_is_told_with_the_files_of_the_row(self):
        self.order("scarab-plant", "configuration", "mass: 3\n")
        code, err = self.sim(f"{self.table}:5")
        self.assertEqual(code, 0)
        self.assertRegex(err, r"was run with configuration [0-9a-f]{8}, this is [0-9a-f]{8} \(plant\.yaml\): it "
                              r"may end otherwise; then it was --config plant=\S*/config/plant\.yaml$")

    def test_what_is_no_row_is_one_line_and_nothing_is_started(self):
        text = self.table.read_text()
        odd = self.folder / "odd.csv"
        odd.write_text("index,strategy\n5,soft\n")
        bad = self.folder / "bad.csv"
        bad.write_text(text.replace(",across,", ",home,"))
        high = self.folder / "high.csv"
        high.write_text(text.replace(",0.05,1.46,", ",0.9,1.46,"))
        before = len(self.journal())
        for row, said in ((f"{self.table}:8", "has no row with index 8; it has 8 rows"),
                          (str(self.table), "is not FILE:N"), (f"{self.table}:x", "is not FILE:N"),
                          ("/no/such.csv:1", "cannot be read: No such file"),
                          (f"{odd}:5", "has no column 'goal'"), (f"{bad}:5", "goal 'home' is none of"),
                          (f"{high}:5", "height_m: 0.9 is out of range [0, 0.5]"),
                          (f"{self.folder}:1", "cannot be read: Is a directory")):
            code, err = self.sim(row)
            self.assertEqual((code, len(err.splitlines())), (2, 1), err)
            self.assertIn(said, err)
        self.assertEqual(len(self.journal()), before)


if __name__ == "__main__":
    unittest.main()
