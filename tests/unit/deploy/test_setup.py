"""deploy/setup.sh: what is installed, by whom, and what is said where that does not work."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from fake_stack import SOURCE_ROOT

INSTALLED = "g++\ncmake\npython3\n"


class Setup(unittest.TestCase):
    """A copy of deploy/ in a folder of its own, with programs that only write down how they are called."""

    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)
        (self.room / "deploy").mkdir()
        for name in ("setup.sh", "packages.txt"):
            (self.room / "deploy" / name).write_text((SOURCE_ROOT / "deploy" / name).read_text())
        (self.room / "bin").mkdir()
        (self.room / "installed").write_text(INSTALLED)
        self.program("dpkg-query", 'for last; do :; done\n'
                     f'grep -qxF "$last" {self.room}/installed && echo "ii "')
        self.program("id", "echo 0")
        self.program("apt-get", f'echo "apt-get $*" >> {self.room}/calls')

    def program(self, name, body):
        file = self.room / "bin" / name
        file.write_text(f"#!/bin/bash\n{body}\n")
        file.chmod(0o755)

    def run_function(self, call, path=None):
        return subprocess.run(
            ["/bin/bash", "-c", f'set -eu; . "$0"; {call}', str(self.room / "deploy" / "setup.sh")],
            capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False,
            env={**os.environ, "PATH": path or f"{self.room}/bin:/usr/bin:/bin"})

    def calls(self):
        file = self.room / "calls"
        return file.read_text().splitlines() if file.exists() else []

    def test_groups_of_the_package_list(self):
        build = self.run_function("packages_of build").stdout.split()
        both = self.run_function("packages_of build test").stdout.split()
        self.assertIn("cyclonedds-dev", build)
        self.assertNotIn("libgtest-dev", build)
        self.assertEqual(both[:len(build)], build)
        self.assertIn("libgtest-dev", both)
        self.assertEqual(len(both), len(set(both)))

    def test_only_what_is_not_installed_is_missing(self):
        missing = self.run_function("missing_packages build run").stdout.split()
        self.assertNotIn("g++", missing)
        self.assertNotIn("python3", missing)
        self.assertIn("python3-yaml", missing)

    def test_removed_package_with_its_configuration_left_is_missing(self):
        self.program("dpkg-query", 'echo "rc "')
        self.assertIn("g++", self.run_function("missing_packages build").stdout.split())

    def test_nothing_missing_calls_nobody(self):
        self.program("dpkg-query", 'echo "ii "')
        done = self.run_function("install_packages build run")
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        self.assertEqual(self.calls(), [])

    def test_lists_are_fetched_only_when_they_are_not_enough(self):
        self.assertEqual(self.run_function("install_packages run").returncode, 0)
        self.assertFalse([c for c in self.calls() if c.endswith(" update")])
        self.assertIn("--no-install-recommends python3-yaml", self.calls()[-1])
        # A machine without lists: installing fails until they are there.
        self.program("apt-get", f'echo "apt-get $*" >> {self.room}/calls\n'
                     f'case "$*" in *update) touch {self.room}/lists ;; esac\n'
                     f'[ -e {self.room}/lists ]')
        self.assertEqual(self.run_function("install_packages run").returncode, 0)
        self.assertTrue([c for c in self.calls() if c.endswith(" update")])

    def test_failed_installation_shows_its_log_and_what_to_do(self):
        self.program("apt-get", "echo 'E: no route to the mirror'; exit 100")
        done = self.run_function("install_packages run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("E: no route to the mirror", done.stderr)
        self.assertIn("as root: apt-get update && apt-get install", done.stderr)

    def test_without_root_rights_it_says_what_root_should_do(self):
        self.program("id", "echo 1000")
        self.program("sudo", "exit 1")
        done = self.run_function("install_packages run")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "neither as root nor with sudo.*apt-get install .*python3-yaml")
        self.assertEqual(self.calls(), [])

    def test_sudo_is_used_where_it_works(self):
        self.program("id", "echo 1000")
        # sudo -n is the question whether it would ask for a password.
        self.program("sudo", f'echo "sudo $*" >> {self.room}/calls; [ "$1" = -n ] || exec "$@"')
        self.assertEqual(self.run_function("install_packages run").returncode, 0)
        self.assertTrue([c for c in self.calls() if c.startswith("sudo env DEBIAN_FRONTEND")])

    def test_failed_build_shows_the_error_and_names_the_log(self):
        self.program("cmake", 'case "$*" in *--build*) ;; *) exit 0 ;; esac\n'
                     'echo "[1/3] a.cpp"; echo "FAILED: b.o"; echo "b.cpp:1: error: no"; exit 1')
        done = self.run_function("build_release -DX=1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("b.cpp:1: error: no", done.stderr)
        self.assertIn("build/build.log", done.stderr)


if __name__ == "__main__":
    unittest.main()
