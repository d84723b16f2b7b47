"""What is read of an experiment's directory, and what is said of one that does not serve."""

import json
import tempfile
import unittest
from pathlib import Path

from made_up import CONFIGURATION, LOST, TOO_SLOW, outcome, planned, trial, write_plan, write_results
from made_up_log import FAKE_BIN, neural_activity, write_log

from report.experiment import read_experiment
from report.failure import ReportError
from report.neural import recording
from report.plan import KINDS
from report.rerun import rerun_command, row_command
from report.trial import failure_kind, is_loss


class Reading(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.directory = Path(room.name) / "obstacle"
        self.trials = planned([{"strategy": "soft"}, {"strategy": "soft+hard"}], 3)
        write_plan(self.directory, self.trials, "obstacle")
        write_results(self.directory, self.trials, lambda asked: outcome(asked["strategy"] != "soft", 17.3))

    def read(self):
        return read_experiment(self.directory, FAKE_BIN)

    def refused(self, pattern):
        with self.assertRaisesRegex(ReportError, pattern) as caught:
            self.read()
        self.assertNotIn("\n", str(caught.exception))

    def edit(self, name, change):
        file = self.directory / name
        file.write_text(change(file.read_text()))

    def test_cells_are_the_plan_s_with_their_trials(self):
        experiment = self.read()
        self.assertTrue(experiment.is_complete)
        self.assertEqual([(cell.key.strategy, cell.count, cell.planned) for cell in experiment.cells],
                         [("soft", "0/3", 3), ("soft+hard", "3/3", 3)])
        self.assertEqual(experiment.at("soft+hard", 0.1).times_s, [17.3] * 3)
        self.assertIsNone(experiment.at("soft+hard", 0.2))
        self.assertIsNone(experiment.trials[0].mode2_s)

    def test_half_an_experiment_is_one_with_fewer_trials(self):
        write_results(self.directory, self.trials[:4], lambda asked: outcome())
        experiment = self.read()
        self.assertFalse(experiment.is_complete)
        self.assertEqual([cell.n for cell in experiment.cells], [3, 1])

    def test_a_trial_of_two_grids_counts_once(self):
        twice = [*self.trials, *({**t, "index": t["index"] + 6} for t in self.trials)]
        write_plan(self.directory, twice, "obstacle")
        write_results(self.directory, twice, lambda asked: outcome())
        self.assertEqual([(cell.n, cell.planned) for cell in self.read().cells], [(3, 3), (3, 3)])

    def test_missing_files_columns_and_cut_rows_are_named(self):
        self.edit("results.csv", lambda text: text[:-25])
        self.refused(r"results\.csv:7: 2\d fields instead of 26; is the row cut\?$")
        self.edit("results.csv", lambda text: text.replace("heading_max_rad,climb_s", "heading_max,climb"))
        self.refused(r"results\.csv has no column heading_max_rad, climb_s$")
        (self.directory / "results.csv").unlink()
        self.refused(r"results\.csv: No such file or directory$")

    def test_values_of_the_wrong_kind_are_named(self):
        for before, after, place in (("17.3", "soon", "time_s: 'soon'"), ("17.3", "nan", "time_s: 'nan'"),
                                     (",1,17.3", ",yes,17.3", "success: 'yes'")):
            with self.subTest(after=after):
                write_results(self.directory, self.trials, lambda asked: outcome(time_s=17.3))
                self.edit("results.csv", lambda text: text.replace(before, after, 1))
                self.refused(rf"results\.csv:2: {place} is no value of this column$")

    def test_rows_of_another_plan_or_configuration_are_refused(self):
        self.edit("results.csv", lambda text: text.replace("1000002", "1000009", 1))
        self.refused("the trial with index 2 is not the one of plan.json")
        write_results(self.directory, self.trials, lambda asked: outcome())
        self.edit("results.csv", lambda text: text.replace(CONFIGURATION, "00000000", 1))
        self.refused("index 1 was run with configuration 00000000, plan.json says " + CONFIGURATION)

    def test_a_row_that_stands_twice_is_refused(self):
        self.edit("results.csv", lambda text: text + text.splitlines()[-1] + "\n")
        self.refused(r"results\.csv:8: index 6 stands in an earlier row, too")

    def test_a_plan_that_is_none_is_refused(self):
        for text, pattern in (("{", "is not JSON"), ("[]", "is no JSON object"), ("{}", "name: expected a text")):
            with self.subTest(text=text):
                (self.directory / "plan.json").write_text(text)
                self.refused(pattern)
        write_plan(self.directory, self.trials, "pie chart")
        self.refused("figure: 'pie chart' is none of " + ", ".join(KINDS))
        write_plan(self.directory, [], "obstacle")
        self.refused("trials: expected the list of planned trials")
        write_plan(self.directory, [{"index": 1}], "obstacle")
        self.refused(r"trials\[0\]: has no strategy, goal")


class Logs(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.directory = Path(room.name) / "cpg"
        self.asked = [trial(i, "table-forward", 1, height_m=0.0, object_mass_kg=i) for i in (1, 2)]
        write_plan(self.directory, self.asked, "cpg")
        write_results(self.directory, self.asked, lambda asked: outcome())

    def test_a_log_is_known_by_its_trial_not_by_its_name(self):
        for asked in self.asked:
            write_log(self.directory / f"of-{3 - asked['index']}.mcap", asked, {
                "neural_activity": {**neural_activity("table-forward"), "cpg[0]": [asked["index"]] * 120}})
        experiment = read_experiment(self.directory, FAKE_BIN)
        self.assertEqual(recording(experiment, "table-forward").neuron("C1"), [1.0] * 120)

    def refused(self, pattern, bin=FAKE_BIN):
        with self.assertRaisesRegex(ReportError, pattern):
            recording(read_experiment(self.directory, bin), "table-forward")

    def test_what_keeps_a_log_from_being_read_is_said(self):
        self.refused("cpg has no log of table-forward, seed 1, no obstacle$")
        log = self.directory / "trial.mcap"
        log.write_text("no log")
        self.refused(r"trial\.mcap: .*not an MCAP file$")
        self.refused("scarab-log is needed to read .* and is not built", bin=self.directory)
        write_log(log, self.asked[0], {})
        self.refused("has no samples of scarab/neural_activity$")
        short = {name: values[:20] for name, values in neural_activity("table-forward").items()}
        write_log(log, self.asked[0], {"neural_activity": short})
        self.refused("has 20 ticks; 60 are needed$")


class Reasons(unittest.TestCase):
    def test_kinds_of_failure_are_those_of_the_referee(self):
        kinds = {LOST: "object lost sideways", TOO_SLOW: "time limit",
                 "the object was lost: 0.81 m from the trunk's end, limit 0.80 m": "object lost along the path",
                 "the robot overturned: tilt 1.31 rad, limit 1.30 rad": "robot overturned"}
        for reason, kind in kinds.items():
            self.assertEqual(failure_kind(reason), kind)
        referee = (Path(__file__).resolve().parents[3] / "services/plant/core/referee.cpp").read_text()
        for words in ("sideways", "object was lost", "overturned", "time limit"):
            self.assertIn(words, referee)

    def test_losing_is_failing_otherwise_than_by_time(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        trials = planned([{"strategy": "hard"}], 3)
        write_plan(Path(directory.name), trials, "obstacle")
        results = iter((outcome(False, 9.0, LOST), outcome(False, 60.0, TOO_SLOW), outcome()))
        write_results(Path(directory.name), trials, lambda asked: next(results))
        found = read_experiment(Path(directory.name), FAKE_BIN).trials
        self.assertEqual(list(map(is_loss, found)), [True, False, False])


UNPERTURBED = {"perturb_position_m": 0.0, "perturb_yaw_rad": 0.0, "perturb_friction": 0.0, "perturb_cpg_phase": False}


class Rerun(unittest.TestCase):
    def command(self, **changes):
        with tempfile.TemporaryDirectory() as room:
            asked = [trial(17, "soft+hard", 1000004, **changes)]
            write_plan(Path(room), asked, "obstacle")
            conditions = json.loads((Path(room) / "plan.json").read_text())["trials"][0]
            write_results(Path(room), asked, lambda _: outcome())
            return rerun_command(read_experiment(Path(room), FAKE_BIN).trials[0].asked), conditions

    def test_says_every_condition(self):
        found, _ = self.command(friction_scale=0.75, object_mass_kg=2.5, object_diameter_m=0.2)
        self.assertEqual(found, "deploy/scarab sim --strategy soft+hard --height 0.1 --goal across --time-limit 60 "
                         "--seed 1000004 --friction-scale 0.75 --object-mass 2.5 --object-diameter 0.2 "
                         "--perturb-position 0.02 --perturb-yaw 0.05235987755982988 --perturb-friction 0.1")

    def test_says_nothing_that_is_not_of_the_trial(self):
        found, _ = self.command(goal="walk", height_m=0.0, distance_m=3.0, **UNPERTURBED)
        self.assertEqual(found, "deploy/scarab sim --strategy soft+hard --height 0 --goal walk --distance 3 "
                         "--time-limit 60 --seed 1000004 --no-perturbation")

    def test_what_no_options_can_say_is_left_to_the_row(self):
        self.assertEqual(self.command(perturb_cpg_phase=False)[0], "")

    def test_a_row_is_named_from_the_top_of_the_source_tree(self):
        root = Path(__file__).resolve().parents[3]
        asked = type("Asked", (), {"index": 17})
        self.assertEqual(row_command(root / "runs" / "experiments" / "obstacle", asked),
                         "deploy/scarab sim --row runs/experiments/obstacle/results.csv:17")


if __name__ == "__main__":
    unittest.main()
