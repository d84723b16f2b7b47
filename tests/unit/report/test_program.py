"""deploy/report/report.py as a person calls it."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from every_kind import write_experiment
from made_up import SOURCE_ROOT
from made_up_log import FAKE_BIN

SCRIPT = SOURCE_ROOT / "deploy" / "report" / "report.py"


class Program(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)
        write_experiment(self.room / "robustness", "robustness")

    def call(self, *words, hash_seed="0"):
        return subprocess.run([str(SCRIPT), *map(str, words), "--bin", str(FAKE_BIN)], capture_output=True, text=True,
                              check=False, env={**os.environ, "PYTHONHASHSEED": hash_seed})

    def test_writes_reports_and_an_index(self):
        done = self.call(self.room / "robustness", "--index", self.room / "index.html")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, f"{self.room}/robustness/report.html\n{self.room}/index.html\n")
        self.assertTrue((self.room / "index.html").is_file())

    def test_another_process_writes_the_same_bytes(self):
        written = []
        for hash_seed in ("1", "2"):
            self.assertEqual(self.call(self.room / "robustness", hash_seed=hash_seed).returncode, 0)
            written.append({file.name: file.read_bytes() for file in sorted((self.room / "robustness").iterdir())})
        self.assertEqual(*written)

    def test_one_that_does_not_serve_does_not_keep_the_others(self):
        (self.room / "empty").mkdir()
        done = self.call(self.room / "empty", self.room / "robustness")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, f"report.py: {self.room}/empty/plan.json: No such file or directory\n")
        self.assertEqual(done.stdout, f"{self.room}/robustness/report.html\n")

    def test_bad_usage_is_told(self):
        done = self.call(self.room / "nowhere")
        self.assertEqual(done.returncode, 2)
        self.assertIn("nowhere is no directory", done.stderr)
        self.assertIn("deploy/report/report.py runs/experiments/obstacle", self.call("--help").stdout)


if __name__ == "__main__":
    unittest.main()
