"""deploy/plot/walk.py on a made-up walk."""

import csv
import hashlib
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE_ROOT = Path(__file__).resolve().parents[3]
SCRIPT = SOURCE_ROOT / "deploy" / "plot" / "walk.py"
sys.path.insert(0, str(SCRIPT.parent))

from walk_panels import stances  # noqa: E402
from walk_table import WalkTableError, read_walks  # noqa: E402

SPEED_M_S = 0.1
TURN_RAD_S = 0.05
HEADING_RAD = 0.3  # at the start
POSE = ("header.trial", "header.sim_time_ns", "trunk.position_m[0]", "trunk.position_m[1]",
        "trunk.orientation_wxyz[0]", "trunk.orientation_wxyz[1]", "trunk.orientation_wxyz[2]",
        "trunk.orientation_wxyz[3]", "contacts.length")
CONTACT = ("solid_a", "leg_a", "solid_b", "leg_b", "point_m[0]", "point_m[1]")


class WalkFigure(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)
        self.world = self.room / "forward.csv"
        self.write(self.world)

    def write(self, file, named=True):
        """Two trials of 10 s straight on along the first heading while the trunk turns left; the
        front left foot steps once a second."""
        solids = ("SOLID_GROUND", "SOLID_FOOT") if named else ("0", "7")
        with open(file, "w", newline="") as out:
            table = csv.writer(out)
            table.writerow([*POSE, *(f"contacts[0].{name}" for name in CONTACT)])
            for trial in (1, 2):
                for i in range(101):
                    time_s = 0.1 * i
                    way = SPEED_M_S * time_s
                    yaw = HEADING_RAD + TURN_RAD_S * time_s
                    down = i % 10 < 6
                    table.writerow([
                        trial, round(time_s * 1e9), 2 + way * math.cos(HEADING_RAD),
                        3 + way * math.sin(HEADING_RAD), math.cos(yaw / 2), 0, 0,
                        math.sin(yaw / 2), int(down),
                        *([solids[0], 0, solids[1], 0, 2.2, 3.2] if down else [""] * 6)])

    def run_script(self, *words):
        return subprocess.run([str(SCRIPT), *map(str, words)], capture_output=True, text=True,
                              check=False)

    def test_measures_along_the_first_heading(self):
        walks = read_walks(self.world)
        self.assertEqual([walk.trial for walk in walks], [1, 2])
        for walk in walks:
            self.assertAlmostEqual(walk.time_s, 10)
            self.assertAlmostEqual(walk.speed_m_s, SPEED_M_S)
            self.assertAlmostEqual(walk.sideways_m, 0)
            self.assertAlmostEqual(walk.turned_deg, math.degrees(10 * TURN_RAD_S))
            self.assertAlmostEqual(walk.tilt_deg, 0)

    def test_counts_turns_beyond_half_a_circle(self):
        text = self.world.read_text()
        header, *rows = text.splitlines()
        turned = [header]
        for i, row in enumerate(rows[:101]):
            cells = row.split(",")
            yaw = 0.1 * i  # ten rad in all
            cells[4], cells[7] = str(math.cos(yaw / 2)), str(math.sin(yaw / 2))
            turned.append(",".join(cells))
        self.world.write_text("\n".join(turned))
        self.assertAlmostEqual(read_walks(self.world)[0].turned_deg, math.degrees(10))

    def test_finds_the_stances_of_a_foot(self):
        walk = read_walks(self.world)[0]
        found = stances(walk, 0)
        self.assertEqual(len(found), 11)
        self.assertEqual(found[1], (10, 15))
        self.assertEqual(stances(walk, 3), [])

    def test_takes_enumerators_by_name_and_by_number(self):
        numbered = self.room / "numbered.csv"
        self.write(numbered, named=False)
        self.assertEqual(read_walks(self.world), read_walks(numbered))

    def test_prints_a_row_for_each_trial_and_draws_nothing_unasked(self):
        done = self.run_script(self.world)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(done.stdout.splitlines()), 3)
        self.assertIn("+0.100", done.stdout)
        self.assertEqual(list(self.room.glob("*.png")), [])

    def test_equal_walks_give_equal_pictures(self):
        sums = []
        for name in ("once", "twice"):
            done = self.run_script(self.world, "--output", self.room / name)
            self.assertEqual(done.returncode, 0, done.stderr)
            sums.append([hashlib.sha256((self.room / f"{name}.{kind}").read_bytes()).hexdigest()
                         for kind in ("svg", "png")])
        self.assertEqual(sums[0], sums[1])

    def test_says_what_a_table_lacks(self):
        header, *rows = self.world.read_text().splitlines()
        self.world.write_text("\n".join([header.replace("trunk.position_m[0]", "x"), *rows]))
        with self.assertRaisesRegex(WalkTableError, "no column trunk.position_m"):
            read_walks(self.world)
        self.assertEqual(self.run_script(self.world).returncode, 1)
        self.world.write_text(header + "\n")
        with self.assertRaisesRegex(WalkTableError, "no rows"):
            read_walks(self.world)

    def test_says_that_elements_were_left_out(self):
        self.world.write_text(self.world.read_text().replace("contacts[0]", "other[0]"))
        done = self.run_script(self.world)
        self.assertEqual(done.returncode, 1)
        self.assertIn("--elements", done.stderr)

    def test_refuses_two_walks_of_one_name(self):
        again = self.room / "again"
        again.mkdir()
        self.write(again / "forward.csv")
        self.assertEqual(self.run_script(self.world, again / "forward.csv").returncode, 2)


if __name__ == "__main__":
    unittest.main()
