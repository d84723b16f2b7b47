#!/usr/bin/python3
"""However the launcher ends in the middle, nothing of it stays, and the same command goes on."""

import signal
import unittest

from case import IN_PROCESS, ON_STACKS, ExperimentCase, done, table


class Interruptions(ExperimentCase):
    def test_resumed_it_is_as_if_nothing_had_happened(self):
        whole = table(self.run_into("whole", *IN_PROCESS))
        for words in (IN_PROCESS, ON_STACKS):
            for number in (signal.SIGINT, signal.SIGKILL):
                with self.subTest(words=words, signal=number):
                    self.interrupted_and_resumed(whole, number, words)

    def interrupted_and_resumed(self, whole, number, words):
        name = f"{words[0]}-{number}"
        directory, code, err = self.stopped_in_the_middle(name, number, *words)
        before = done(directory)
        if number == signal.SIGINT:
            self.assertEqual(code, 130, err)
            self.assertIn(f"interrupted after {len(before)} of 16 trials; the same command goes on", err)
        self.run_into(name, *words)
        self.assertEqual(table(directory), whole)
        self.assertEqual(done(directory)[:len(before)], before)
        self.assertEqual(len(done(directory)), 16)  # nothing was run twice


if __name__ == "__main__":
    unittest.main()
