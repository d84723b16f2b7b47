"""Bad usage of deploy/demo: exit code 2 before anything is installed or built."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from fake_stack import SOURCE_ROOT
from launcher.cli import all_verbs
from launcher.verbs import options_of

PLACES = ("--stack", "--bin", "--runs")  # which demo does not have: it runs what it has built

GOOD = (["--height", "0.10"], ["--height=.08"], ["--height", "0"], ["--strategy", "boxing+hard"],
        ["--seed", "18446744073709551615"], ["--trials", "10", "--no-perturbation"],
        ["--goal", "travel", "--distance", "1e0"], ["--goal=walk", "--height", "0"],
        ["--perturb-position", "0", "--perturb-yaw", "3.14", "--perturb-friction", ".25"],
        ["--friction-scale", "1.25", "--object-mass", "3", "--object-diameter", "0.22"], ["--domain", "7"],
        ["--realtime", "--no-log"],
        ["--lockstep", "--robot", "beetle"], ["--replicas", "premotor=2"],
        ["--replicas=premotor=2,supervisor=1"], ["--interface", "lo"], ["--profile", "control-host"],
        ["--config", f"plant={SOURCE_ROOT}/config/plant/beetle.yaml"],
        ["--profile", "robot", "--emulated"], ["--profile", "robot", "--driver", "amosii", "--emulated"],
        ["--profile", "robot", "--robot=beetle", "--driver=dynamixel", "--emulated", "--realtime"])
BAD = (["--height"], ["--height", "high"], ["--height", "nan"], ["--height", "-0.1"],
       ["--height", "0.51"], ["--height", "1e9"], ["--strategy", "softly"], ["--strategy", ""],
       ["--strategy", "soft boxing"], ["--seed", "-1"], ["--seed", "1.5"],
       ["--seed", "18446744073709551616"], ["--trials", "0"], ["--trials", "100001"],
       ["--time-limit", "0"], ["--goal", "home"], ["--goal", "across", "--height", "0"],
       ["--realtime", "--lockstep"], ["--realtime=1"], ["--robot", "betle"], ["--robot", ""],
       ["--replicas", "premotor"], ["--replicas", "premotor=0"], ["--replicas", "premotor=9"],
       ["--replicas", "premotor=2,"], ["--config", "plant"], ["--config", "plant=/no/such/file"],
       ["--profile", "a b"], ["--domain", "231"], ["--no-perturbation=1"],
       ["--perturb-position", "0.21"], ["--perturb-yaw", "180"], ["--perturb-friction", "1"],
       ["--friction-scale", "0"], ["--object-mass", "-1"], ["--object-diameter", "2"], ["--row", "3"],
       ["--emulated"], ["--profile", "sim", "--emulated"], ["--driver", "dynamixel"], ["--device", "/dev/ttyUSB0"],
       ["--profile", "robot", "--driver", "dynamixl"], ["--profile", "robot", "--robot", "beetle", "--driver", "x"],
       ["--profile", "robot", "--emulated", "--device", "/dev/x"], ["--profile", "robot", "--lockstep"],
       ["--profile", "robot", "--emulated=yes"], ["--profile", "control-host", "--emulated"],
       ["--row", "/no/such.csv:3"], ["--row", f"{SOURCE_ROOT}/README.md:x"], ["--heigth", "0.1"], ["nonsense"])
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

        # The supervisor alone knows its strategies; this one says what is in its file.
        (self.room / "bin").mkdir()
        supervisor = self.room / "bin" / "scarab-supervisor"
        supervisor.write_text('#!/bin/sh\nwhile [ "$1" != --config ]; do shift; done; cat "$2"\n')
        supervisor.chmod(0o755)
        shutil.copy("/bin/true", self.room / "bin" / "scarab-experiment")

    def demo(self, words):
        environment = {**os.environ, "PATH": f"{self.room}:/usr/bin:/bin"}
        return subprocess.run([str(SOURCE_ROOT / "deploy" / "demo"), *words], capture_output=True,
                              text=True, env=environment, check=False)

    def touched(self):
        return (self.room / "touched").exists()

    def launcher(self, words):
        """The launcher with the same words; most programs are not there, so good words end with 1."""
        return subprocess.run(
            [str(SOURCE_ROOT / "deploy" / "scarab"), "run", "--bin", str(self.room / "bin"),
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
                # On a domain of its own: others are taken by tests that run beside this one.
                own = [] if "--domain" in words else ["--domain", "229"]
                done = self.launcher([*words, *own])
                self.assertEqual((done.returncode, "is not built" in done.stderr), (1, True),
                                 done.stderr)

    def test_same_options_as_the_launcher(self):
        of_launcher = set(options_of(all_verbs().parsers["run"])) - {"-h", "--help", *PLACES}
        script = (SOURCE_ROOT / "deploy" / "arguments.sh").read_text()
        table = script[script.index("kind_of()"):script.index("robots()")]
        self.assertEqual(set(re.findall(r"--[a-z-]+", table)), of_launcher)
        in_help = set(re.findall(r"^  (--[a-z-]+)", self.demo(["--help"]).stdout, re.MULTILINE))
        self.assertLessEqual(in_help, of_launcher)
        self.assertGreater(len(in_help), 10)

    def test_file_that_builds_on_another_is_left_to_the_supervisor(self):
        shutil.copytree(SOURCE_ROOT / "deploy", self.room / "tree" / "deploy")
        shutil.copytree(SOURCE_ROOT / "config", self.room / "tree" / "config")
        file = self.room / "tree" / "config" / "supervisor" / "beetle.yaml"
        file.write_text("extends: other.yaml\nstrategies:\n  mine: {approach: stop, push: []}\n")
        done = subprocess.run(
            ["bash", "-c", '. deploy/setup.sh; . deploy/arguments.sh; check_arguments --strategy theirs'],
            cwd=self.room / "tree", capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
