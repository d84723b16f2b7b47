"""A log that is several files: their order, and a trial that goes on from one to the next."""

import tempfile
import unittest
from pathlib import Path

import fake_stack  # noqa: F401  puts the launcher on the path
from launcher.failure import Failure
from launcher.figure import trial_rows
from launcher.log_files import is_open, log_files
from launcher.places import Places
from launcher.signals import Signals

EXPORT = """#!/bin/sh
[ "$1 $3 $4 $5 $6 $7 $8" = "export --format csv --topic scarab/behaviour --trial 4" ] || exit 2
grep -q tick "$2" || { echo "scarab-log: no topic scarab/behaviour" >&2; exit 1; }
cat "$2"
"""


class LogFiles(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)

    def write(self, name, text=""):
        (self.room / name).write_text(text)
        return self.room / name

    def names(self):
        return [log.name for log in log_files(self.room)]

    def test_they_are_in_the_order_of_writing(self):
        for name in ("trial-10.mcap", "trial-2.mcap", "trial.mcap", "trial-11.mcap.active", "results.csv", "trial.log"):
            self.write(name)
        self.assertEqual(self.names(), ["trial.mcap", "trial-2.mcap", "trial-10.mcap", "trial-11.mcap.active"])
        self.assertEqual([is_open(log) for log in log_files(self.room)], [False, False, False, True])

    def test_mended_one_stands_for_the_one_left_open(self):
        for name in ("trial.mcap.active", "trial.mcap", "trial-2.mcap.active"):
            self.write(name)
        self.assertEqual(self.names(), ["trial.mcap", "trial-2.mcap.active"])

    def test_directory_without_a_log_has_none(self):
        self.assertEqual(log_files(self.room), [])
        self.assertEqual(log_files(self.room / "none"), [])

    def rows(self, *logs):
        program = self.write("scarab-log", EXPORT)
        program.chmod(0o755)
        places = Places(self.room, self.room, self.room)
        return "".join(trial_rows(places, logs, "behaviour", 4, self.room / "part.csv", Signals()))

    def test_trial_goes_on_from_file_to_file(self):
        first, second, third = (self.write(f"{n}.mcap", text) for n, text in enumerate(
            ("tick\n", "tick\n1\n2\n", "tick\n2\n3\n")))  # a restarted logger is told the newest sample once more
        self.assertEqual(self.rows(first, second, third), "tick\n1\n2\n3\n")

    def test_file_that_has_no_such_topic_yet_is_passed_over(self):
        log, empty = self.write("0.mcap", "tick\n1\n"), self.write("1.mcap")
        self.assertEqual(self.rows(log, empty), "tick\n1\n")

    def test_trial_that_is_in_no_file_as_yet_has_but_a_heading(self):
        self.assertEqual(self.rows(self.write("0.mcap", "tick\n"), self.write("1.mcap", "tick\n")), "tick\n")

    def test_reason_is_the_tools_where_no_file_can_be_read(self):
        with self.assertRaisesRegex(Failure, "^scarab-log: no topic scarab/behaviour$"):
            self.rows(self.write("0.mcap"))


if __name__ == "__main__":
    unittest.main()
