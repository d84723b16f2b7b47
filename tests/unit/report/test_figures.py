"""Figures: one of each kind, readable in grey."""

import re
import tempfile
import unittest
from pathlib import Path

from every_kind import plans, write_experiment
from made_up import LOST, outcome, planned, write_plan, write_results
from made_up_log import FAKE_BIN

from report.experiment import read_experiment
from report.failure import ReportError
from report.figures import DRAWINGS, draw_figures
from report.figures.spread_out import spread_out
from report.figures.style import MODES
from report.plan import KINDS
from report.walk import read_walk


def lightness(colour):
    """0 black to 1 white, as a grey printer sees it (ITU-R BT.709)."""
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]


class Figures(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)

    def draw(self, directory):
        return draw_figures(read_experiment(directory, FAKE_BIN), directory)

    def test_every_kind_is_drawn_without_a_date(self):
        self.assertEqual(set(DRAWINGS), set(KINDS))
        self.assertEqual(set(plans()), set(KINDS))
        for kind in KINDS:
            with self.subTest(kind=kind):
                write_experiment(self.room / kind, kind)
                svg, png = self.draw(self.room / kind)
                self.assertEqual((svg.name, png.name), (f"{kind}.svg", f"{kind}.png"))
                self.assertIn("<svg", svg.read_text())
                self.assertTrue(png.read_bytes().startswith(b"\x89PNG"))
                self.assertNotRegex(svg.read_text(), r"<dc:date>|20\d\d-\d\d-\d\dT")

    def test_the_same_data_give_the_same_bytes(self):
        for kind in ("transport_speed", "vrn"):  # bars and dots; lines, markers and formulae
            drawn = []
            for copy in ("first", "second"):
                write_experiment(self.room / copy / kind, kind)
                drawn.append(self.draw(self.room / copy / kind))
            for one, other in zip(*drawn):
                self.assertEqual(one.read_bytes(), other.read_bytes(), one.name)

    def test_perturbation_and_counts_stand_on_the_figure(self):
        # Text is drawn as paths; matplotlib leaves what it says in a comment.
        write_experiment(self.room / "transport_speed", "transport_speed")
        said = re.findall("<!-- (.*?) -->", self.draw(self.room / "transport_speed")[0].read_text(), re.DOTALL)
        everything = " ".join(" ".join(said).split())
        for words in ("start ±2 cm, ±3°", "friction ±10 %", "CPG phase", "4/4", "none arrived", "4 × lost"):
            self.assertIn(words, everything)

    def test_other_data_give_another_picture(self):
        drawn = []
        for time_s in (20.0, 30.0):
            directory = self.room / f"{time_s:g}" / "beyond"
            trials = planned([{"strategy": "soft+hard"}], 3)
            write_plan(directory, trials, "beyond")
            write_results(directory, trials, lambda asked, t=time_s: outcome(True, t))
            drawn.append(self.draw(directory)[1].read_bytes())
        self.assertNotEqual(*drawn)

    def test_extremes_are_drawn(self):
        """Nobody arrives; one trial alone has been run."""
        for kind in ("transport_speed", "obstacle", "beyond", "robustness"):
            trials = plans()[kind]
            for name, run, done in (("all-fail", lambda asked: outcome(False, 9.0, LOST), len(trials)),
                                    ("one-arrives", lambda _: outcome(), 1)):
                with self.subTest(kind=kind, name=name):
                    directory = self.room / f"{kind}-{name}"
                    write_plan(directory, trials, kind)
                    write_results(directory, trials[:done], run)
                    self.assertEqual(len(self.draw(directory)), 2)

    def test_what_cannot_be_drawn_is_said_in_a_line(self):
        for kind in KINDS:
            with self.subTest(kind=kind):
                write_experiment(self.room / kind, kind, done=0)
                with self.assertRaises(ReportError) as caught:
                    self.draw(self.room / kind)
                self.assertNotIn("\n", str(caught.exception))

    def test_walking_is_drawn_without_logs_too(self):
        write_experiment(self.room / "walking", "walking")
        with_logs = self.draw(self.room / "walking")[1].read_bytes()
        for log in (self.room / "walking").glob("*.mcap"):
            log.unlink()
        self.assertNotEqual(self.draw(self.room / "walking")[1].read_bytes(), with_logs)

    def test_a_walk_is_seen_from_its_start(self):
        write_experiment(self.room / "walking", "walking")
        experiment = read_experiment(self.room / "walking", FAKE_BIN)
        asked = experiment.trials[1].asked
        walk = read_walk(experiment, asked)
        self.assertEqual((walk.x_m[0], walk.y_m[0], walk.heading_rad[0]), (0.0, 0.0, 0.0))
        self.assertAlmostEqual(walk.x_m[-1], 3.0)
        self.assertAlmostEqual(walk.heading_rad[-1], 0.03 * (asked.seed % 10))
        self.assertAlmostEqual(walk.distance_m[-1], 3.0, places=3)


class Grey(unittest.TestCase):
    def test_modes_differ_in_marker_hatch_and_lightness(self):
        modes = [MODES[name] for name in ("soft", "boxing", "stationary", "hard")]
        for part in (1, 2):
            self.assertEqual(len({mode[part] for mode in modes}), len(modes))
        found = sorted(lightness(colour) for colour, _, _ in modes)
        self.assertTrue(all(b - a > 0.04 for a, b in zip(found, found[1:])), found)

    def test_dots_stand_apart(self):
        for count in (0, 1, 2, 10, 40):
            shifts = spread_out(count, 0.3)
            self.assertEqual(len(set(shifts)), count)
            self.assertTrue(all(abs(shift) <= 0.3 + 1e-12 for shift in shifts))


if __name__ == "__main__":
    unittest.main()
