"""Experiments as they are written down: strict reading, the trials they stand for, shards."""

import itertools
import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import jsonschema
import yaml
from experiment_case import EXPERIMENT
from fake_stack import SCARAB, SOURCE_ROOT
from launcher.experiment_verb import list_text
from launcher.experiments.declaration import experiment_schema
from launcher.experiments.experiment_file import find_experiment, known_experiments, read_experiment
from launcher.experiments.plan import TRIAL_KEYS, Shard, make_plan
from launcher.experiments.results import COLUMNS
from launcher.failure import ConfigError, UsageError

NAMES = ("beyond", "cpg", "obstacle", "obstacle_high", "psn", "robustness", "sequence", "transport_speed", "vrn",
         "walking")
STRATEGIES = yaml.safe_load((SOURCE_ROOT / "config" / "supervisor" / "beetle.yaml").read_text())["strategies"]
LAST_SEED_OF_A_SEARCH = 999_999


def plan_of(name):
    return make_plan(read_experiment(find_experiment(name, SOURCE_ROOT)))


def read(text):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "tiny.yaml"
        file.write_text(text)
        return read_experiment(file)


class Reading(unittest.TestCase):
    def mistake(self, text):
        """`line:col: key: reason`."""
        with self.assertRaises(ConfigError) as caught:
            read(text)
        match = re.fullmatch(r".*/tiny\.yaml:(\d+:\d+: .*)", str(caught.exception))
        self.assertIsNotNone(match, str(caught.exception))
        return match[1]

    def test_every_mistake_is_one_line_with_its_place(self):
        for old, new, said in (
                ("title:", "titel:", "2:1: titel: unknown key (did you mean 'title'?)"),
                ("title: A tiny experiment\n", "", "2:1: title: missing key"),
                ("figure: obstacle", "figure: obstackle", "3:9: figure: unknown value 'obstackle' (did you"),
                ("paper: [Says little.]", "paper: []", "4:8: paper: must name at least one"),
                ("[0.05, 0.1]", "[0.05, 0.6]", "7:22: grids[0].height_m[1]: 0.6 is out of range [0, 0.5]"),
                ("[0.05, 0.1]", "[]", "7:15: grids[0].height_m: must name at least one"),
                ("[0.05, 0.1]", "0.05", "7:15: grids[0].height_m: expected a list, found a number '0.05'"),
                ("[0.05, 0.1]", "[0.05, 0.05]", "7:15: grids[0].height_m: names a value twice"),
                ("[0.05, 0.1]", "[0.0, 0.1]", "6:5: grids[0]: goal across needs an obstacle"),
                ("    height_m: [0.05, 0.1]\n", "", "neither the grid nor every_trial says height_m"),
                ("{goal: across,", "{goal: home,", "8:21: every_trial.goal: unknown value 'home'"),
                ("{goal: across,", "{height_m: 0.1, goal: across,", "is in every_trial, too"),
                ("trials: 3", "trials: 0", "9:9: trials: 0 is out of range [1, 100000]"),
                ("first_seed: 1000001", f"first_seed: {2**64 - 2}", "10:13: first_seed: leaves no 3 seeds"),
                ("cpg_phase: true", "cpg_phase: yes", "expected true or false, found 'yes'"),
                ("cpg_phase: true", "cpg_phase: false", "false, although position_m is perturbed")):
            with self.subTest(new=new):
                self.assertIn(old, EXPERIMENT)
                self.assertIn(said, self.mistake(EXPERIMENT.replace(old, new)))

    def test_name_that_is_not_known(self):
        with self.assertRaisesRegex(UsageError, "did you mean 'transport_speed'"):
            find_experiment("transport_sped", SOURCE_ROOT)


class Schema(unittest.TestCase):
    def test_file_is_current(self):
        printed = subprocess.run([str(SCARAB), "config", "schema", "experiment"], check=True,
                                 capture_output=True, text=True).stdout
        self.assertEqual((SOURCE_ROOT / "config" / "schema" / "experiment.json").read_text(), printed,
                         "deploy/scarab config schema experiment > config/schema/experiment.json")

    def test_it_takes_what_the_reader_takes_and_refuses_what_that_refuses(self):
        validator = jsonschema.Draft7Validator(json.loads(experiment_schema()))
        for file in (SOURCE_ROOT / "config" / "experiments").glob("*.yaml"):
            self.assertTrue(validator.is_valid(yaml.safe_load(file.read_text())), file)
        for old, new in (("title:", "titel:"), ("trials: 3", "trials: 0"), ("[0.05, 0.1]", "[]"),
                         ("figure: obstacle", "figure: pie"), ("goal: across", "goal: home")):
            self.assertFalse(validator.is_valid(yaml.safe_load(EXPERIMENT.replace(old, new))), new)


class Plans(unittest.TestCase):
    def test_cells_are_the_product_in_the_order_given_and_have_the_same_seeds(self):
        trials = make_plan(read(EXPERIMENT)).trials
        self.assertEqual([t.index for t in trials], list(range(12)))
        self.assertEqual([(t.strategy, t.height_m) for t in trials[::3]],
                         [("soft", 0.05), ("soft", 0.1), ("soft+hard", 0.05), ("soft+hard", 0.1)])
        for cell in range(4):
            self.assertEqual([t.seed for t in trials[3 * cell:3 * cell + 3]], [1000001, 1000002, 1000003])

    def test_numbers_of_the_caller_replace_those_of_the_file(self):
        trials = make_plan(read(EXPERIMENT), 2, 7).trials
        self.assertEqual([t.seed for t in trials], [7, 8] * 4)
        self.assertEqual(make_plan(read(EXPERIMENT), 1, 0).first_seed, 0)

    def test_line_has_the_keys_of_the_protocol_and_the_numbers_as_they_are(self):
        trial = make_plan(read(EXPERIMENT)).trials[5]
        line = json.loads(trial.line())
        self.assertEqual(tuple(line), TRIAL_KEYS)
        self.assertEqual((line["height_m"], line["perturb_cpg_phase"], line["friction_scale"],
                          line["object_mass_kg"]), (0.1, True, 1, 0))

    def test_shards_divide_the_trials(self):
        plan = make_plan(read(EXPERIMENT))
        for of in range(1, 15):
            parts = [plan.of_shard(Shard(number, of)) for number in range(1, of + 1)]
            indices = [trial.index for part in parts for trial in part]
            self.assertEqual(sorted(indices), list(range(12)))
            self.assertLessEqual(max(map(len, parts)) - min(map(len, parts)), 1)


class OfTheRepository(unittest.TestCase):
    def test_all_are_there_and_listed(self):
        self.assertEqual(tuple(known_experiments(SOURCE_ROOT)), NAMES)
        listed = [line.split()[0] for line in list_text(SOURCE_ROOT).splitlines()[1:]]
        self.assertEqual(sorted(listed), sorted(NAMES))
        self.assertEqual(listed[:6], ["cpg", "psn", "vrn", "transport_speed", "obstacle", "sequence"])

    def test_every_trial_can_be_run_and_no_search_has_seen_its_seed(self):
        for name in NAMES:
            for trial in plan_of(name).trials:
                self.assertIn(trial.strategy, STRATEGIES, name)
                self.assertGreater(trial.seed, LAST_SEED_OF_A_SEARCH, name)

    def test_file_says_its_schema_in_its_first_line(self):
        for name in NAMES:
            first = find_experiment(name, SOURCE_ROOT).read_text().splitlines()[0]
            self.assertEqual(first, "# yaml-language-server: $schema=../schema/experiment.json")

    def test_those_that_are_measured_are_perturbed_as_much_as_the_issue_asks(self):
        for name in NAMES:
            for trial in plan_of(name).trials:
                if trial.goal != "none":
                    self.assertGreaterEqual(trial.perturb_position_m, 0.02, name)
                    self.assertGreaterEqual(trial.perturb_yaw_rad, 3 * 3.14159 / 180, name)
                    self.assertGreaterEqual(trial.perturb_friction, 0.1, name)
                    self.assertTrue(trial.perturb_cpg_phase, name)

    def test_second_experiment_is_that_of_the_paper(self):
        trials = plan_of("obstacle").trials
        cells = {(t.strategy, t.height_m) for t in trials}
        singles = ("soft", "boxing", "stationary")
        strategies = [*singles, *(f"{name}+hard" for name in singles)]
        self.assertEqual(cells, set(itertools.product(strategies, [n / 100 for n in range(2, 12)])))
        self.assertEqual(len(trials), 600)
        self.assertEqual({(t.goal, t.time_limit_s) for t in trials}, {("across", 60)})


class Page(unittest.TestCase):
    """docs/experiments.md."""

    text = (SOURCE_ROOT / "docs" / "experiments.md").read_text()

    def test_it_lists_the_columns_in_their_order(self):
        section = self.text[self.text.index("### Columns"):self.text.index("### One trial again")]
        listed = [name for row in re.findall(r"^\| (`[^|]*) \|", section, re.MULTILINE)
                  for name in re.findall(r"`([a-z0-9_]+)`", row)]
        self.assertEqual(tuple(listed), COLUMNS)

    def test_it_names_every_experiment_with_its_figure(self):
        for name in NAMES:
            row = re.search(rf"^\| (?:`\w+`, )?`{name}`.*$", self.text, re.MULTILINE)
            self.assertIsNotNone(row, name)
            figure = read_experiment(find_experiment(name, SOURCE_ROOT)).paper_figure
            self.assertIn(figure.removeprefix("Fig. ") or "| - |", row[0])

    def test_its_example_is_an_experiment(self):
        example = self.text[self.text.index("```yaml\n") + 8:]
        self.assertEqual(len(make_plan(read(example[:example.index("```")])).trials), 40)


class Checked(unittest.TestCase):
    """`scarab config check`."""

    def check(self, *files):
        return subprocess.run([str(SCARAB), "config", "check", *map(str, files)], capture_output=True,
                              text=True, check=False)

    def test_experiments_of_the_repository_are_right(self):
        files = sorted((SOURCE_ROOT / "config" / "experiments").glob("*.yaml"))
        done = self.check(*files)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.splitlines(), [f"{file}: ok" for file in files])

    def test_every_file_of_config_by_the_program_that_reads_it(self):
        files = sorted((SOURCE_ROOT / "config").glob("*/*.yaml"))
        done = self.check(*files)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(sorted(done.stdout.splitlines()), sorted(f"{file}: ok" for file in files))

    def test_mistake_is_one_line_with_its_place(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "experiments" / "tiny.yaml"
            file.parent.mkdir()
            file.write_text(EXPERIMENT.replace("trials: 3", "trials: many"))
            done = self.check(file)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(done.stderr, f"{file}:9:9: trials: expected an integer, found a text 'many'\n")


if __name__ == "__main__":
    unittest.main()
