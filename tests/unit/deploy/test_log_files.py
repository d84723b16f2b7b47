"""A log that is several files: which they are, and their order."""

import tempfile
import unittest
from pathlib import Path

import fake_stack  # noqa: F401  puts the launcher on the path
from launcher.log_files import is_open, log_files


class LogFiles(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)

    def write(self, name):
        (self.room / name).write_text("")

    def names(self):
        return [log.name for log in log_files(self.room)]

    def test_they_are_in_the_order_of_writing(self):
        for name in ("trial-10.mcap", "trial-2.mcap", "trial.mcap", "trial-11.mcap.active", "results.csv", "trial.log"):
            self.write(name)
        self.assertEqual(self.names(), ["trial.mcap", "trial-2.mcap", "trial-10.mcap", "trial-11.mcap.active"])
        self.assertEqual([is_open(log) for log in log_files(self.room)], [False, False, False, True])

    def test_file_for_each_trial(self):
        for name in ("trial-0002.mcap", "trial.mcap", "trial-0001-2.mcap", "trial-0001.mcap"):
            self.write(name)
        self.assertEqual(self.names(), ["trial.mcap", "trial-0001.mcap", "trial-0001-2.mcap", "trial-0002.mcap"])

    def test_mended_one_stands_for_the_one_left_open(self):
        for name in ("trial.mcap.active", "trial.mcap", "trial-2.mcap.active"):
            self.write(name)
        self.assertEqual(self.names(), ["trial.mcap", "trial-2.mcap.active"])

    def test_directory_without_a_log_has_none(self):
        self.assertEqual(log_files(self.room), [])
        self.assertEqual(log_files(self.room / "none"), [])


if __name__ == "__main__":
    unittest.main()
