"""Bad usage of deploy/demo: exit code 2 before anything is installed or built."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from fake_stack import SOURCE_ROOT

GOOD = (["--height", "0.10"], ["--height=.08"], ["--height", "0"], ["--strategy", "boxing+hard"],
        ["--seed", "18446744073709551615"], ["--trials", "10", "--no-perturbation"],
        ["--goal", "travel", "--distance", "1e0"], ["--domain", "7"])
BAD = (["--height"], ["--height", "high"], ["--height", "nan"], ["--height", "-0.1"],
       ["--height", "0.51"], ["--height", "1e9"], ["--strategy", "softly"], ["--strategy", ""],
       ["--strategy", "soft boxing"], ["--seed", "-1"], ["--seed", "1.5"],
       ["--seed", "18446744073709551616"], ["--trials", "0"], ["--trials", "100001"],
       ["--time-limit", "0"], ["--goal", "home"], ["--goal", "across", "--height", "0"],
       ["--domain", "231"], ["--no-perturbation=1"], ["--heigth", "0.1"], ["nonsense"])
# Whatever sets up or builds goes through one of these.
TOUCHING = ("apt-get", "dpkg-query", "sudo", "cmake", "ninja", "mkdir")


class DemoUsage(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)
        for name in TOUCHING:
            program = self.room / name
            program.write_text(f"#!/bin/sh\necho {name} >> {self.room}/touched\nexit 1\n")
            program.chmod(0o755)

    def demo(self, words):
        environment = {**os.environ, "PATH": f"{self.room}:/usr/bin:/bin"}
        return subprocess.run([str(SOURCE_ROOT / "deploy" / "demo"), *words], capture_output=True,
                              text=True, env=environment, check=False)

    def touched(self):
        return (self.room / "touched").exists()

    def launcher(self, words):
        """The launcher with the same words; it has no programs, so good words end with 1."""
        return subprocess.run(
            [str(SOURCE_ROOT / "deploy" / "scarab"), "run", "--bin", str(self.room / "empty"),
             "--runs", str(self.room / "runs"), *words], capture_output=True, text=True, check=False)

    def test_bad_words_end_with_2_and_touch_nothing(self):
        for words in BAD:
            with self.subTest(words=words):
                done = self.demo(words)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertEqual(done.stdout, "")
                self.assertFalse(self.touched())

    def test_good_words_go_on_to_the_packages(self):
        for words in GOOD:
            with self.subTest(words=words):
                self.assertEqual(self.demo(words).returncode, 1)
                self.assertTrue(self.touched())
                (self.room / "touched").unlink()

    def test_help_touches_nothing(self):
        done = self.demo(["--help"])
        self.assertEqual(done.returncode, 0)
        self.assertIn("--strategy", done.stdout)
        self.assertFalse(self.touched())

    def test_launcher_agrees(self):
        for words in BAD:
            with self.subTest(words=words):
                self.assertEqual(self.launcher(words).returncode, 2)
        for words in GOOD:
            with self.subTest(words=words):
                done = self.launcher(words)
                self.assertEqual((done.returncode, "is not built" in done.stderr), (1, True),
                                 done.stderr)


if __name__ == "__main__":
    unittest.main()
