"""report.html, index.html and summary.json: they stand alone, and say what the data say."""

import json
import re
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

from every_kind import plans, write_experiment
from made_up import CONFIGURATION, outcome, planned, write_plan, write_results
from made_up_log import FAKE_BIN

from report import ReportError, write, write_index

VOID = {"meta", "link", "img", "br", "hr", "input"}


class Checker(HTMLParser):
    """Every element is closed, every reference is to an id of the page, every id is unique."""

    def __init__(self):
        super().__init__()
        self.open, self.ids, self.references, self.words = [], [], [], []

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append(tag)
        for name, value in attrs:
            if name == "id":
                self.ids.append(value)
            if name in ("href", "src", "data", "poster") or "url(" in (value or ""):
                self.references.append((tag, name, value))

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        self.handle_endtag(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-3:]}"
        self.open.pop()

    def handle_data(self, data):
        self.words.append(data)


def checked(text):
    checker = Checker()
    checker.feed(text)
    checker.close()
    assert not checker.open, checker.open
    return checker


class Page(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)

    def written(self, kind, done=None, **changes):
        """The page's checker; other keys of plan.json as given."""
        directory = self.room / kind
        write_experiment(directory, kind, done)
        if changes:
            write_plan(directory, plans()[kind], kind, **changes)
        files = write(directory, FAKE_BIN)
        self.assertEqual([file.name for file in files],
                         [f"{kind}.svg", f"{kind}.png", "summary.json", "report.html"])
        return checked((directory / "report.html").read_text())

    def assert_stands_alone(self, checker, text):
        self.assertNotIn("http", text)
        self.assertNotRegex(text, r"<(script|link|img|iframe|object)\b|@import")
        self.assertEqual(len(checker.ids), len(set(checker.ids)))
        for tag, name, value in checker.references:
            inside = re.fullmatch(r"(?:url\()?#([^)]*)\)?.*", value or "", re.DOTALL)
            targets = [inside.group(1)] if inside else re.findall(r"url\(#([^)]*)\)", value or "")
            self.assertTrue(targets and set(targets) <= set(checker.ids), (tag, name, value))

    def test_it_stands_alone(self):
        for kind in ("transport_speed", "psn"):
            checker = self.written(kind)
            self.assert_stands_alone(checker, (self.room / kind / "report.html").read_text())

    def test_it_says_what_a_reader_needs(self):
        text = " ".join(self.written("transport_speed", paper=["Soft is <fastest>."], notes="Slips & slides.",
                                     sessions=[{"wall_s": 10.0, "simulated_s": 500.0}]).words)
        for words in ("Soft is <fastest>.", "Slips & slides.", "Fig. 0", CONFIGURATION, "seeds 1000001 to 1000004",
                      "deploy/scarab experiment transport_speed --inproc",
                      "start ±2 cm, ±3°, friction ±10 %, CPG phase uniform",
                      "results.csv:1", "--seed 1000001", "agrees", "hard, flat", "4 × object lost sideways",
                      "Failures: 4 of 16 trials", "results.csv:5", "50 × real time"):
            self.assertIn(words, text)
        self.assertNotIn("not finished", text)

    def test_half_an_experiment_says_so_on_top(self):
        words = self.written("obstacle", done=14).words
        text = " ".join(words)
        self.assertIn("14 of 36 trials.", text)
        self.assertLess(text.index("14 of 36 trials."), text.index("What the paper says"))
        self.assertIn("2/2, 3 planned", text)
        self.assertIn("0 of 3 run", text)
        self.assertFalse(json.loads((self.room / "obstacle" / "summary.json").read_text())["complete"])

    def test_a_missing_log_is_said_on_the_page_and_as_an_error(self):
        write_experiment(self.room / "cpg", "cpg")
        (self.room / "cpg" / "trial-1.mcap").unlink()
        with self.assertRaisesRegex(ReportError, "could not be drawn: .*has no log of table-backward"):
            write(self.room / "cpg", FAKE_BIN)
        text = " ".join(checked((self.room / "cpg" / "report.html").read_text()).words)
        self.assertIn("has no log of table-backward", text)
        self.assertIn("not measured", text)

    def test_summary_has_the_numbers(self):
        self.written("transport_speed")
        summary = json.loads((self.room / "transport_speed" / "summary.json").read_text())
        self.assertEqual((summary["planned"], summary["trials"], summary["complete"]), (16, 16, True))
        soft, hard = summary["cells"][:2]
        self.assertEqual((soft["strategy"], soft["n"], soft["successes"]), ("soft", 4, 4))
        self.assertAlmostEqual(soft["mean_s"], 11.75)
        self.assertAlmostEqual(soft["wilson_95"][0], 0.5101, places=4)
        self.assertEqual(soft["wilson_95"][1], 1.0)
        self.assertEqual((hard["mean_s"], hard["failures"]), (None, {"object lost sideways": 4}))
        self.assertEqual([f["verdict"] for f in summary["findings"]], ["agrees"] * 3)
        self.assertEqual(summary["configuration"], CONFIGURATION)

    def test_written_again_it_is_the_same(self):
        self.written("robustness")
        first = {name: (self.room / "robustness" / name).read_bytes() for name in ("summary.json", "report.html")}
        write(self.room / "robustness", FAKE_BIN)
        for name, content in first.items():
            self.assertEqual((self.room / "robustness" / name).read_bytes(), content)

    def test_index_has_every_experiment(self):
        for kind in ("transport_speed", "beyond"):
            self.written(kind)
        out = write_index([self.room / "transport_speed", self.room / "beyond"], self.room / "index.html")
        text = out.read_text()
        checker = checked(text)
        self.assertEqual(len(checker.ids), len(set(checker.ids)))
        links = {value for tag, _, value in checker.references if tag == "a"}
        self.assertEqual(links, {"transport_speed/report.html", "beyond/report.html"})
        self.assertEqual(text.count("<svg"), 2)
        self.assertNotIn("http", text)
        said = " ".join(checker.words)
        for words in ("Soft pushing moves the object", "deploy/scarab experiment beyond --inproc", "38 of 40"):
            self.assertIn(words, said)

    def test_index_of_what_has_no_report_is_refused(self):
        with self.assertRaisesRegex(ReportError, "summary.json"):
            write_index([self.room], self.room / "index.html")

    def test_what_a_plan_says_is_no_markup(self):
        directory = self.room / "beyond"
        trials = planned([{"strategy": "soft+hard"}], 2)
        write_plan(directory, trials, "beyond", title='"><script>alert(1)</script>', version="<b>")
        write_results(directory, trials, lambda asked: outcome(False, 3.0, "<i>why"))
        write(directory, FAKE_BIN)
        text = (directory / "report.html").read_text()
        checked(text)
        self.assertNotIn("<script", text)
        self.assertNotIn("<b>", text)
        self.assertNotIn("<i>why", text)


if __name__ == "__main__":
    unittest.main()
