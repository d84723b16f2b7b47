"""Result lines, the table and the journal they go to, and what is said of the time that is left."""

import io
import json
import tempfile
import unittest
from pathlib import Path

from experiment_case import EXPERIMENT  # puts the launcher on the path, too
from launcher.experiments.estimate import Estimate, duration
from launcher.experiments.experiment_file import read_experiment
from launcher.experiments.journal import Journal, read_journal
from launcher.experiments.outcome_table import outcome_tables
from launcher.experiments.plan import make_plan
from launcher.experiments.progress import Progress
from launcher.experiments.results import ForeignLine, error_of, is_final_error, read_result, table
from launcher.failure import Failure

OUTCOME = ('"success": true, "time_s": 12.500000000000002, "reason": "said \\"across\\", at last", '
           '"object_travel_m": 1e-17, "object_sideways_m": -0.25, "trunk_travel_m": 0, "heading_rad": 0.1, '
           '"heading_max_rad": 0.30000000000000004, "climb_s": 2, "mode1_s": 2.5, "mode2_s": null')


class Room(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.file = Path(room.name) / "journal.jsonl"
        experiment = Path(room.name) / "tiny.yaml"
        experiment.write_text(EXPERIMENT)
        self.plan = make_plan(read_experiment(experiment))
        self.trials = self.plan.trials
        self.planned = {trial.index: trial for trial in self.trials}

    def line(self, number, **changes):
        """A result as a worker writes it: 60, not 60.0."""
        trial = json.loads(self.trials[number].line())
        trial = {key: int(v) if isinstance(v, float) and v.is_integer() else v for key, v in trial.items()}
        values = {**trial, **json.loads("{" + OUTCOME + "}"), **changes}
        return json.dumps(values)

    def result(self, number, **changes):
        return read_result(self.line(number, **changes), self.planned)


class Results(Room):
    def test_row_has_the_digits_of_the_line(self):
        row = self.result(4).row("0123abcd")
        self.assertEqual(row, [
            "4", "soft", "across", "0.1", "1.46", "60", "1000002", "0.02", "0.05", "0.1", "1", "1", "0", "0",
            "1", "12.500000000000002", 'said "across", at last', "1e-17", "-0.25", "0", "0.1",
            "0.30000000000000004", "2", "2.5", "", "0123abcd"])

    def test_table_is_sorted_by_index_and_quoted_where_it_has_to_be(self):
        lines = table([self.result(7), self.result(2, success=False)], "0123abcd").splitlines()
        self.assertTrue(lines[0].startswith("index,strategy,goal,height_m,"))
        self.assertTrue(lines[0].endswith(",mode2_s,configuration"))
        self.assertEqual([line.split(",")[0] for line in lines[1:]], ["2", "7"])
        self.assertIn(',0,12.500000000000002,"said ""across"", at last",', lines[1])

    def test_what_is_not_the_result_of_the_trial_is_refused(self):
        for line, said in (("", "no JSON object"), ("[]", "no JSON object"), ("{}", "other keys"),
                           (self.line(4, index=12), "trial 12, which is not in the plan"),
                           (self.line(4, index="4"), "not in the plan"),
                           (self.line(4, seed=1), "with seed 1"), (self.line(4, height_m=0.05), "with height_m"),
                           (self.line(4, success=1), "neither success nor failure"),
                           (self.line(4, time_s=None), "no time"), (self.line(4, wall_s=1), "other keys"),
                           (self.line(4)[:-9], "no JSON object")):
            with self.assertRaisesRegex(ForeignLine, said):
                read_result(line, self.planned)

    def test_error_lines_are_told_apart(self):
        self.assertIsNone(error_of(self.line(1)))
        self.assertIsNone(error_of("a line of the debugger"))
        of_a_trial, of_all = '{"index": 3, "error": "plant is silent"}', '{"error": "unknown key"}'
        self.assertEqual((error_of(of_a_trial), is_final_error(of_a_trial)), ("plant is silent", False))
        self.assertEqual((error_of(of_all), is_final_error(of_all)), ("unknown key", True))


class Journals(Room):
    def written(self, *lines):
        journal = Journal(self.file)
        for line in lines:
            journal.add(line)
        journal.close()

    def indices(self):
        return [result.trial.index for result in read_journal(self.file, self.trials)]

    def test_without_a_file_nothing_has_been_done(self):
        self.assertEqual(self.indices(), [])

    def test_lines_are_there_at_once_and_come_back(self):
        journal = Journal(self.file)
        journal.add(self.line(3))
        self.assertEqual(self.indices(), [3])
        journal.add(self.line(0))
        self.assertEqual(self.indices(), [3, 0])
        journal.close()

    def test_torn_line_is_none_and_does_not_spoil_the_next(self):
        self.written(self.line(3))
        with open(self.file, "a") as file:
            file.write(self.line(4)[:40])
        self.assertEqual(self.indices(), [3])
        self.written(self.line(5))
        self.assertEqual(self.indices(), [3, 5])

    def test_trial_that_was_done_twice_counts_once(self):
        self.written(self.line(3), self.line(3, success=False), self.line(1))
        self.assertEqual([(r.trial.index, r.success) for r in read_journal(self.file, self.trials)],
                         [(3, True), (1, True)])

    def test_line_of_another_plan_is_a_failure_with_its_place(self):
        self.written(self.line(3), self.line(3, seed=5))
        with self.assertRaisesRegex(Failure, r"journal\.jsonl:2: is of trial 3, but with seed 5"):
            self.indices()


class Clock(Room):
    def setUp(self):
        super().setUp()
        self.now = 100.0
        self.estimate = Estimate([], self.trials, lambda: self.now)


class Left(Clock):
    def test_nothing_is_said_before_anything_is_known(self):
        self.assertIsNone(self.estimate.left_s())
        self.assertIsNone(self.estimate.speed)

    def test_trials_of_a_cell_are_expected_to_last_alike(self):
        self.now += 10
        self.estimate.add(self.result(0, time_s=10))   # soft, 5 cm
        self.estimate.add(self.result(3, time_s=60))   # soft, 10 cm
        self.estimate.add(self.result(6, time_s=10))   # soft+hard, 5 cm
        self.estimate.add(self.result(9, time_s=20))   # soft+hard, 10 cm
        self.assertEqual(self.estimate.speed, 10)
        self.assertAlmostEqual(self.estimate.left_s(), 2 * (10 + 60 + 10 + 20) / 10)

    def test_cell_of_which_nothing_is_known_is_like_its_strategy_or_like_all(self):
        self.now += 1
        self.estimate.add(self.result(0, time_s=10))
        self.assertAlmostEqual(self.estimate.left_s(), 11)

    def test_trials_of_an_earlier_session_tell_how_long_but_not_how_fast(self):
        estimate = Estimate([self.result(0, time_s=10)], self.trials[1:], lambda: self.now)
        self.assertIsNone(estimate.left_s())
        self.now += 2
        estimate.add(self.result(1, time_s=10))
        self.assertEqual(estimate.speed, 5)
        self.assertAlmostEqual(estimate.left_s(), 10 * 10 / 5)

    def test_it_falls_to_nothing(self):
        last = float("inf")
        for index in range(12):
            self.now += 5
            self.estimate.add(self.result(index, time_s=50))
            self.assertLess(self.estimate.left_s(), last)
            last = self.estimate.left_s()
        self.assertEqual(last, 0)

    def test_duration_in_words(self):
        self.assertEqual([duration(s) for s in (0.4, 59.6, 65, 3600, 36000 + 61)],
                         ["0:00", "1:00", "1:05", "1:00:00", "10:01:01"])


class Terminal(io.StringIO):
    def isatty(self):
        return True


class Shown(Clock):
    def progress(self, stream):
        return Progress("tiny", 12, [], self.estimate, stream, lambda: self.now)

    def run_through(self, stream):
        progress = self.progress(stream)
        for index in range(12):
            self.now += 4
            result = self.result(index, time_s=50, success=index % 2 == 0)
            self.estimate.add(result)
            progress.add(result)
            progress.show()
        progress.finish()
        return stream.getvalue()

    def test_terminal_has_one_line_that_is_written_over(self):
        text = self.run_through(Terminal())
        self.assertEqual(text.count("\n"), 1)
        self.assertEqual(text.count("\r"), 13)

    def test_file_has_a_line_now_and_then(self):
        lines = self.run_through(io.StringIO()).splitlines()
        self.assertEqual(len(lines), 1 + 3 + 1)  # at once, each 12 s, at the end
        self.assertEqual(lines[-1], f"tiny [{'=' * 24}] 12/12, 6 succeeded, 12 x real time")

    def test_it_says_what_is_left(self):
        progress = self.progress(io.StringIO())
        self.assertIn("starting", progress.text())
        self.now += 10
        self.estimate.add(self.result(0, time_s=50))
        progress.add(self.result(0, time_s=50))
        self.assertRegex(progress.text(60), r"^tiny \[ {9}\] 1/12, 1 succeeded, 5 x real time, 1:50 left$")
        self.assertEqual(len(progress.text(30)), 30)
        self.assertEqual(progress.text(), f"tiny [{'=' * 2}{' ' * 22}] 1/12, 1 succeeded, 5 x real time, 1:50 left")


class Tables(Room):
    def test_rows_are_strategies_and_columns_heights(self):
        results = [self.result(i, success=i % 3 != 0, time_s=10 + i) for i in range(10)]
        self.assertEqual(outcome_tables(self.plan, results).splitlines(), [
            "succeeded: strategy \\ height m  0.05  0.1",
            "soft                             2/3  2/3",
            "soft+hard                        2/3  0/1",
            "",
            "mean time s: strategy \\ height m  0.05   0.1",
            "soft                              11.5  14.5",
            "soft+hard                         17.5     -"])


if __name__ == "__main__":
    unittest.main()
