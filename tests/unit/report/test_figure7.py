"""deploy/plot/figure7.py on made-up samples."""

import csv
import hashlib
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE_ROOT = Path(__file__).resolve().parents[3]
SCRIPT = SOURCE_ROOT / "deploy" / "plot" / "figure7.py"
sys.path.insert(0, str(SOURCE_ROOT / "deploy"))

from report.failure import ReportError  # noqa: E402
from report.figures.sequence import spans  # noqa: E402
from report.signal_table import join_tables, read_table  # noqa: E402

BEHAVIOURS = (("APPROACH", "BACKWARD", 20), ("CLIMB", "BACKWARD", 8), ("MODE_1", "SOFT_PUSH", 60),
              ("MODE_2", "HARD_PUSH", 40), ("DONE", "STOP", 1))
TICK_NS = 100_000_000


class Figure7(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)
        self.behaviour = self.room / "behaviour.csv"
        self.robot_state = self.room / "robot_state.csv"
        self.write_behaviour(lambda state: f"BEHAVIOUR_{state}")
        self.write_robot_state(range(sum(count for *_, count in BEHAVIOURS)))

    def write_behaviour(self, state_text):
        with open(self.behaviour, "w", newline="") as file:
            table = csv.writer(file)
            table.writerow(["header.sim_time_ns", "mode", "state", "bs_rad", "bs_threshold_rad",
                            "as_rad", "as_threshold_rad"])
            tick = 0
            for state, mode, count in BEHAVIOURS:
                for _ in range(count):
                    table.writerow([tick * TICK_NS, f"MODE_{mode}", state_text(state),
                                    0.001 * tick, 0.15, 1.0 - 0.001 * tick, 0.95])
                    tick += 1

    def write_robot_state(self, ticks):
        with open(self.robot_state, "w", newline="") as file:
            table = csv.writer(file)
            table.writerow(["header.sim_time_ns", *(f"position_rad[{i}]" for i in range(19))])
            for tick in ticks:
                table.writerow([tick * TICK_NS, *(i + math.sin(tick) / 10 for i in range(19))])

    def draw(self, *words):
        return subprocess.run([str(SCRIPT), *map(str, words), "--output", str(self.room / "figure7")],
                              capture_output=True, text=True, check=False)

    def samples(self):
        return ("--behaviour", self.behaviour, "--robot-state", self.robot_state)

    def test_writes_picture_drawing_and_table(self):
        done = self.draw(*self.samples())
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue((self.room / "figure7.png").read_bytes().startswith(b"\x89PNG"))
        self.assertIn("<svg", (self.room / "figure7.svg").read_text())
        self.assertEqual(len((self.room / "figure7.csv").read_text().splitlines()), 130)

    def test_sample_that_the_log_holds_twice_is_one_row(self):
        with open(self.behaviour, "a+") as file:
            file.seek(0)
            file.write(file.readlines()[-1])
        self.assertEqual(self.draw(*self.samples()).returncode, 0)
        self.assertEqual(len((self.room / "figure7.csv").read_text().splitlines()), 130)

    def test_drawn_again_from_its_table_it_is_the_same_file(self):
        self.draw(*self.samples())
        first = {name: hashlib.sha256((self.room / name).read_bytes()).hexdigest()
                 for name in ("figure7.svg", "figure7.png")}
        done = self.draw("--table", self.room / "figure7.csv")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, digest in first.items():
            self.assertEqual(hashlib.sha256((self.room / name).read_bytes()).hexdigest(), digest)

    def test_joints_are_those_of_the_left_legs(self):
        signals = join_tables(self.behaviour, self.robot_state).signals
        for joint, slot in (("TL0", 0), ("TL1", 1), ("TL2", 2), ("CL0", 6), ("CL1", 7), ("CL2", 8)):
            self.assertAlmostEqual(signals[f"{joint}_rad"][0], slot)

    def test_spans_cover_the_trial_without_gaps_in_order(self):
        table = join_tables(self.behaviour, self.robot_state)
        found = spans(table)
        self.assertEqual([(s.state, s.mode) for s in found], [b[:2] for b in BEHAVIOURS])
        self.assertEqual(found[0].start_s, table.time_s[0])
        self.assertEqual(found[-1].end_s, table.time_s[-1])
        for before, after in zip(found, found[1:]):
            self.assertEqual(before.end_s, after.start_s)

    def test_behaviours_may_be_numbers(self):
        names = ["IDLE", "APPROACH", "CLIMB", "MODE_1", "MODE_2", "DONE"]
        by_name = join_tables(self.behaviour, self.robot_state)
        self.write_behaviour(lambda state: str(names.index(state)))
        self.assertEqual(join_tables(self.behaviour, self.robot_state), by_name)

    def of_a_robot(self, trigger, position, imu):
        """The samples as of a robot that measures less than the plant does."""
        def add(file, header, values):
            first, *rows = file.read_text().splitlines()
            file.write_text("\n".join([f"{first},{header}", *(f"{row},{values}" for row in rows)]) + "\n")

        add(self.behaviour, "trigger,trigger_value,trigger_threshold", f"TRIGGER_{trigger},2.5,3")
        slots = range(19)
        add(self.robot_state, ",".join(["imu_source", *(f"position_source[{i}]" for i in slots)]),
            ",".join([f"SOURCE_{imu}", *(f"SOURCE_{position}" for _ in slots)]))

    def test_older_samples_are_of_a_plant_that_measures_all(self):
        table = join_tables(self.behaviour, self.robot_state)
        self.assertEqual((table.trigger, table.position_source, table.imu_source),
                         ("FRONT_ANGLE", "MEASURED", "MEASURED"))
        self.assertEqual(table.signals["trigger_value"], table.signals["as_rad"])

    def test_robot_that_measures_no_angles_has_a_figure_of_its_own_that_can_be_drawn_again(self):
        self.draw(*self.samples())
        drawn = {(self.room / "figure7.svg").read_bytes()}
        for trigger, position, imu in (("SUPPLY_CURRENT", "COMMANDED", "MEASURED"), ("NONE", "COMMANDED", "MEASURED"),
                                       ("NONE", "COMMANDED", "ABSENT")):
            with self.subTest(trigger=trigger, imu=imu):
                self.write_behaviour(lambda state: f"BEHAVIOUR_{state}")
                self.write_robot_state(range(sum(count for *_, count in BEHAVIOURS)))
                self.of_a_robot(trigger, position, imu)
                done = self.draw(*self.samples())
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                figure = (self.room / "figure7.svg").read_bytes()
                self.assertNotIn(figure, drawn)
                drawn.add(figure)
                table = read_table(self.room / "figure7.csv")
                self.assertEqual((table.trigger, table.position_source, table.imu_source), (trigger, position, imu))
                self.assertEqual(set(table.signals["trigger_value"]), {2.5})
                self.draw("--table", self.room / "figure7.csv")
                self.assertEqual((self.room / "figure7.svg").read_bytes(), figure)

    def test_joints_of_different_sources(self):
        self.of_a_robot("FRONT_ANGLE", "MEASURED", "MEASURED")
        text = self.robot_state.read_text()
        self.robot_state.write_text(text.replace("MEASURED,SOURCE_MEASURED", "MEASURED,SOURCE_COMMANDED"))
        self.assertEqual(join_tables(self.behaviour, self.robot_state).position_source, "MIXED")

    def test_only_ticks_of_both_tables_are_drawn(self):
        self.write_robot_state(range(10, 50))
        self.assertEqual(len(join_tables(self.behaviour, self.robot_state).time_s), 40)

    def test_tables_without_a_common_tick_or_column_are_refused_in_words(self):
        self.write_robot_state([])
        done = self.draw(*self.samples())
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^figure7\.py: .* have no tick in common\n$")
        self.behaviour.write_text("state\n")
        with self.assertRaisesRegex(ReportError, "has no column header.sim_time_ns, mode"):
            join_tables(self.behaviour, self.robot_state)
        with self.assertRaisesRegex(ReportError, "has no column"):
            read_table(self.robot_state)


if __name__ == "__main__":
    unittest.main()
