"""Tests with a network of their own: loopback, a pair of interfaces, and nobody else on them."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SOURCE_ROOT = Path(__file__).resolve().parents[3]
SCARAB = SOURCE_ROOT / "deploy" / "scarab"
BIN = Path(os.environ.get("SCARAB_BIN") or SOURCE_ROOT / "build" / "release" / "bin")
TEST_PROGRAMS = Path(os.environ.get("SCARAB_TEST_PROGRAMS") or BIN.parent / "tests")
PATIENCE_S = 30.0
DOMAIN = 4
_INSIDE = "SCARAB_TEST_INSIDE"
_FAR_AWAY = "/usr/bin"  # paths in sentences are relative where that is shorter

sys.path.insert(0, str(SOURCE_ROOT / "deploy"))


def main():
    """Runs the tests of the calling file in a network and mount namespace of their own."""
    if os.environ.get(_INSIDE) != "yes":
        _go_inside()
    sh("ip link set lo up")
    sh("ip link add v0 type veth peer name v1")
    unittest.main()


def _go_inside():
    for rights in ([], ["--user", "--map-root-user"]):
        inside = ["unshare", *rights, "--net", "--mount"]
        if subprocess.run([*inside, "true"], stderr=subprocess.DEVNULL, check=False).returncode == 0:
            os.environ[_INSIDE] = "yes"
            os.execvp("unshare", [*inside, sys.executable, *sys.argv])
    sys.exit("this test needs a network namespace of its own: run it as root, or let users make "
             "namespaces (sysctl kernel.unprivileged_userns_clone=1)")


def sh(command):
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command}: {done.stderr.strip()}")
    return done.stdout


def wait_until(condition, what):
    deadline = time.monotonic() + PATIENCE_S
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"waited in vain until {what}")
        time.sleep(0.02)


class DoctorCase(unittest.TestCase):
    """A folder of its own for each test: its runs, its stack file."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="scarab-doctor-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.runs = self.folder / "runs"
        self.stack_file = SOURCE_ROOT / "deploy" / "stack.yaml"
        self.bin = BIN
        self.environment = {name: value for name, value in os.environ.items()
                            if name not in ("CYCLONEDDS_URI", "NO_COLOR")}

    def command(self, verb, *words):
        return [str(SCARAB), verb, "--stack", str(self.stack_file), "--bin", str(self.bin),
                "--runs", str(self.runs), *words]

    def scarab(self, verb, *words, before=()):
        """The finished launcher; `before` are words in front of the command line."""
        return subprocess.run([*before, *self.command(verb, *words)], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=PATIENCE_S, env=self.environment,
                              cwd=_FAR_AWAY, check=False)

    def doctor(self, *words, before=()):
        """The findings: [(check, level, what, advice)]."""
        done = self.scarab("doctor", "--json", *words, before=before)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        document = json.loads(done.stdout)
        self.assertEqual(document["healthy"], done.returncode == 0)
        found = [(f["check"], f["level"], f["what"], f["advice"]) for f in document["findings"]]
        self.assertEqual(document["healthy"], not [f for f in found if f[1] == "problem"])
        return found

    def only(self, level, *words, before=()):
        """The one finding of that level, as (what, advice)."""
        found = self.doctor(*words, before=before)
        chosen = [f[2:] for f in found if f[1] == level]
        self.assertEqual(len(chosen), 1, found)
        return chosen[0]

    def up(self, *words, domain=DOMAIN, runs=None, before=()):
        """A stack that the test stops."""
        places = ("--runs", str(runs)) if runs else ()
        done = self.scarab("up", "--domain", str(domain), *words, *places, before=before)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.addCleanup(self.scarab, "down", "--domain", str(domain), *places)

    def odd_endpoint(self, *words, domain=DOMAIN, before=()):
        """A process with one reader or writer; there when this returns."""
        return self.start([*before, TEST_PROGRAMS / "odd_endpoint", "--domain", str(domain), *words])

    def start(self, command):
        """A program that says when it is there, and ends with its standard input."""
        process = subprocess.Popen([str(word) for word in command], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, text=True, env=self.environment)
        self.addCleanup(_end, process)
        self.assertEqual(process.stdout.readline(), "there\n", command)
        return process

    def two_interfaces(self):
        """v0 with 10.7.0.1 and v1, both up until the test is over."""
        self.addCleanup(sh, "ip address flush dev v0 && ip link set v0 multicast on down && "
                            "ip link set v1 down")
        sh("ip address add 10.7.0.1/24 dev v0 && ip link set v0 up && ip link set v1 up")

    def stack_with_interface(self, name):
        text = self.stack_file.read_text()
        self.assertIn("interface: lo ", text)
        self.stack_file = self.folder / "stack.yaml"
        self.stack_file.write_text(text.replace("interface: lo ", f"interface: {name} "))


class StackCase(DoctorCase):
    """All tests of the class share one running stack."""

    @classmethod
    def setUpClass(cls):
        cls.shared = Path(tempfile.mkdtemp(prefix="scarab-doctor-stack-"))
        cls.addClassCleanup(shutil.rmtree, cls.shared)
        words = ["--runs", str(cls.shared), "--bin", str(BIN), "--domain", str(DOMAIN)]
        cls.addClassCleanup(subprocess.run, [SCARAB, "down", *words], timeout=PATIENCE_S,
                            capture_output=True, check=False)
        done = subprocess.run([SCARAB, "up", *words], timeout=PATIENCE_S, capture_output=True,
                              text=True, check=False)
        if done.returncode != 0:
            raise AssertionError(done.stdout + done.stderr)

    def setUp(self):
        super().setUp()
        self.runs = self.shared


def _end(process):
    process.stdin.close()
    try:
        process.wait(PATIENCE_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    process.stdout.close()
