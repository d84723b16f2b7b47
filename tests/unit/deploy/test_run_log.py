"""The log of a run: which files it is, what it lacks, and a run without one."""

import json
import re
import unittest

from fake_stack import FakeStackTest


class Log(FakeStackTest):
    def say_of_logger(self, health, message):
        self.order("scarab-status", "document", json.dumps(
            {"services": [{"service": "plant", "health": "degraded", "message": "not of the log"},
                          {"service": "logger", "health": health, "message": message}]}))

    def result_line(self, out, name):
        found = re.search(rf"^{name}: +(.*)$", out, re.MULTILINE)
        return found[1] if found else None

    def test_without_a_log_the_stack_has_no_logger_and_expects_none(self):
        code, out, err = self.scarab("run", "--no-log")
        self.assertEqual(code, 0, err)
        started = [name for what, name in self.journal() if what == "start"]
        self.assertEqual(set(started), {"scarab-plant", "scarab-premotor", "scarab-experiment"})
        self.assertEqual(self.command_of("scarab-plant")["--expect"], "plant=1,premotor=1")
        self.assertEqual(self.command_of("scarab-experiment")["--expect"], "plant=1,premotor=1")
        self.assertIsNone(self.result_line(out, "log"))
        self.assertIn("no figure: without a logger there is no log", err)
        self.assertEqual(self.scarab("run", "--no-log", "--config", "logger=x.yaml")[0], 2)

    def test_whole_log_is_one_line(self):
        self.say_of_logger("ok", "")
        out = self.scarab("run")[1]
        self.assertRegex(self.result_line(out, "log"), r"runs/\S+/trial\.mcap$")
        self.assertIsNone(self.result_line(out, "log lacks"))

    def test_samples_that_were_dropped_are_told_where_the_log_is(self):
        self.say_of_logger("degraded", "17 samples dropped (scarab/robot_sensors 17)")
        out = self.scarab("run")[1]
        self.assertEqual(self.result_line(out, "log lacks"), "17 samples dropped (scarab/robot_sensors 17)")

    def test_all_files_of_a_log_that_was_split_are_named(self):
        self.order("scarab-logger", "files", "2")
        self.assertRegex(self.result_line(self.scarab("run")[1], "log"), r"trial\.mcap, trial-2\.mcap$")
        self.order("scarab-logger", "files", "12")
        self.assertRegex(self.result_line(self.scarab("run")[1], "log"),
                         r"trial\.mcap to trial-12\.mcap, 12 files$")


if __name__ == "__main__":
    unittest.main()
