"""What `scarab log`, `topic`, `emulator`, `calibrate` understand beyond their tools: the newest run, names, slips."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from fake_stack import SCARAB, SOURCE_ROOT

LOG = """#!/bin/sh
case "$*" in
  --help) cat <<'X'
Subcommands:
  info                        what a log holds
  attachments                 list the attached files
  diff                        whether two logs are the same
X
  ;;
  diff*--help) cat <<'X'
Positionals:
  a A REQUIRED                one log
  b B REQUIRED                the other
X
  ;;
  *--help) cat <<'X'
Positionals:
  file FILE ... REQUIRED      the log; of several, all are read as one

Options:
  --extract DIR               write them below this folder
X
  ;;
  *) printf '%s\\n' "$@"; exit 3 ;;
esac
"""


class ToolWords(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name).resolve()
        (self.room / "bin").mkdir()
        for name in ("scarab-log", "scarab-topic", "scarab-emulator", "scarab-calibrate"):
            program = self.room / "bin" / name
            program.write_text(LOG)
            program.chmod(0o755)

    def run_with(self, name, *logs):
        """Makes the newest run."""
        directory = self.room / "runs" / name
        directory.mkdir(parents=True)
        for log in logs:
            (directory / log).write_text("")
        latest = self.room / "runs" / "latest"
        latest.unlink(missing_ok=True)
        latest.symlink_to(name)
        return directory

    def scarab(self, *words):
        done = subprocess.run([str(SCARAB), *words], capture_output=True, text=True, check=False, cwd=self.room,
                              env={**os.environ, "SCARAB_BIN": str(self.room / "bin"),
                                   "SCARAB_RUNS": str(self.room / "runs")})
        return done.returncode, done.stdout.splitlines(), done.stderr

    def refused(self, text, code, *words):
        got, out, err = self.scarab(*words)
        self.assertEqual((got, out, err.count("\n")), (code, [], 1), err)
        self.assertRegex(err, text)

    def test_latest_is_the_log_of_the_newest_run(self):
        self.run_with("2026-01-01-1", "trial.mcap")
        newest = self.run_with("2026-01-01-2", "trial.mcap", "results.csv")
        code, said, err = self.scarab("log", "info", "latest")
        self.assertEqual((code, said), (3, ["info", "runs/2026-01-01-2/trial.mcap"]), err)
        self.assertEqual(err, f"scarab: {newest.relative_to(self.room)}/trial.mcap\n")

    def test_of_several_files_all_are_meant(self):
        names = ("trial.mcap", "trial-2.mcap", "trial-9.mcap", "trial-10.mcap.active")
        directory = self.run_with("2026-01-01-1", *names)
        code, said, err = self.scarab("log", "info", "latest")
        self.assertEqual((code, said), (3, ["info", *(f"runs/2026-01-01-1/{name}" for name in names)]))
        self.assertEqual(err, "scarab: runs/2026-01-01-1/trial.mcap to trial-10.mcap.active, 4 files\n")
        said = self.scarab("log", "diff", "latest", "b.mcap")[1]  # which takes one word for each of two logs
        self.assertEqual(said, ["diff", f"runs/{directory.name}", "b.mcap"])

    def test_log_of_trials_on_a_stack_that_is_up_is_the_stacks(self):
        stack = self.run_with("2026-01-01-1", "trial.mcap.active")
        trials = self.run_with("2026-01-01-2", "results.csv")
        (trials / "stack").symlink_to(Path("..") / stack.name)
        self.assertEqual(self.scarab("log", "info", "latest")[1][1], "runs/2026-01-01-2/stack/trial.mcap.active")

    def test_directory_stands_for_its_log_and_an_options_does_not(self):
        directory = self.run_with("2026-01-01-1", "trial.mcap")
        code, said, _ = self.scarab("log", "attachments", str(directory), "--extract", str(directory))
        self.assertEqual((code, said), (3, ["attachments", "runs/2026-01-01-1/trial.mcap",
                                            "--extract", str(directory)]))

    def test_file_of_that_name_is_meant_itself(self):
        self.run_with("2026-01-01-1", "trial.mcap")
        (self.room / "latest").write_text("")
        self.assertEqual(self.scarab("log", "info", "latest")[1], ["info", "latest"])

    def test_emulator_that_is_told_is_that_of_the_newest_stack(self):
        stack = self.run_with("2026-01-01-1")
        self.assertEqual(self.scarab("emulator", "tell", "latest", "lose", "0.1")[:2],
                         (3, ["tell", str(stack), "lose", "0.1"]))
        trials = self.run_with("2026-01-01-2")
        (trials / "stack").symlink_to(Path("..") / stack.name)
        self.assertEqual(self.scarab("emulator", "tell", "latest", "clear")[:2], (3, ["tell", str(stack), "clear"]))
        self.assertEqual(self.scarab("emulator", "tell", "pipe", "clear")[1], ["tell", "pipe", "clear"])

    def test_names_stand_for_the_files_that_are_calibrated_with(self):
        def files(robot, driver):
            return ["--robot", f"{SOURCE_ROOT}/config/robot/{robot}.yaml",
                    "--config", f"{SOURCE_ROOT}/config/robot_bridge/{robot}-{driver}.yaml"]

        for words, said in ((["--check"], [*files("beetle", "dynamixel"), "--check"]),
                            (["--driver", "amosii", "--again"], [*files("beetle", "amosii"), "--again"]),
                            (["--robot=phantomx", "--yes"], [*files("phantomx", "dynamixel"), "--yes"]),
                            (["--robot", "phantomx", "--config", "my.yaml"],
                             [*files("phantomx", "dynamixel")[:2], "--config", "my.yaml"]),
                            (["--robot", "a.yaml", "--config", "b.yaml"], ["--robot", "a.yaml", "--config", "b.yaml"])):
            with self.subTest(words=words):
                self.assertEqual(self.scarab("calibrate", *words)[:2], (3, said))

    def test_names_that_nobody_can_be_calibrated_with(self):
        for words, text in ((["--driver", "amosi"], "unknown driver 'amosi' .did you mean 'amosii'"),
                            (["--driver", "amosii", "--config", "b.yaml"], "--driver and --config contradict"),
                            (["--robot", "betle"], "unknown robot 'betle' .did you mean 'beetle'")):
            self.refused(text, 2, "calibrate", *words)

    def test_run_without_a_log_is_said(self):
        self.refused("there is no log in runs/latest", 1, "log", "info", "latest")
        self.run_with("2026-01-01-1")
        self.refused("there is no log in runs/2026-01-01-1", 1, "log", "info", "latest")

    def test_log_in_the_place_of_the_command_is_no_riddle(self):
        for log in ("trial.mcap", "runs/1/trial.mcap.active", "latest"):
            self.refused(f"{log} is a log, .* deploy/scarab log info {log}\n", 2, "log", log)

    def test_service_is_a_matter_of_another_verb(self):
        directory = self.run_with("2026-01-01-1", "trial.mcap")
        (directory / "logs").mkdir()
        (directory / "logs" / "premotor.log").write_text("")
        self.refused("what premotor wrote shows deploy/scarab logs premotor\n", 2, "log", "premotor")

    def test_topic_in_the_place_of_the_command_is_none_either(self):
        self.refused("is a topic, .* deploy/scarab topic echo rt/tf\n", 2, "topic", "rt/tf")

    def test_other_words_are_handed_on_as_they_are(self):
        for words in (["info", "a.mcap"], ["no-such"], ["--extract", "b"]):
            self.assertEqual(self.scarab("log", *words)[:2], (3, words))


if __name__ == "__main__":
    unittest.main()
