"""A domain that another stack has, ports that are taken, participant indices that run out."""

import contextlib
import os
import socket
import subprocess

import case
from case import BIN, DOMAIN, DoctorCase

BASE_PORT = 7400 + 250 * DOMAIN


@contextlib.contextmanager
def held(*ports):
    """UDP ports that are not shared."""
    with contextlib.ExitStack() as sockets:
        for port in ports:
            one = sockets.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
            one.bind(("", port))
        yield


def participant():
    """Whether one can be made on the domain: (exit code, what it says)."""
    done = subprocess.run([BIN / "scarab-doctor", "--domain", str(DOMAIN), "--timeout", "0.01"],
                          capture_output=True, text=True, timeout=case.PATIENCE_S, check=False)
    return done.returncode, done.stderr


class Domain(DoctorCase):
    words = ("--domain", str(DOMAIN))

    def test_free_domain(self):
        self.assertEqual(self.doctor("domain", "ports", *self.words), [
            ("domain", "ok", "DDS domain 4 is free", ""),
            ("ports", "ok", "64 of 64 participant indices of DDS domain 4 are left", "")])

    def test_domain_of_another_source_trees_stack(self):
        theirs = self.folder / "theirs"
        self.up(runs=theirs)
        what, advice = self.only("problem", "domain", *self.words)
        self.assertRegex(what, r"^DDS domain 4 is in use by another stack: keeper scarab \(pid \d+\), "
                               rf"run directory {theirs}/\d+-\d+-\d+-1$")
        self.assertIn("deploy/scarab down", advice)
        self.assertIn("--domain 5", advice)

    def test_domain_of_other_dds_programs(self):
        self.odd_endpoint("--topic", "somebodys/topic")
        what, advice = self.only("note", "domain", *self.words)
        self.assertRegex(what, r"other DDS programs are: odd_endpoint \(pid \d+\)$")
        self.assertIn("--domain 5", advice)

    def test_port_of_a_program_that_does_not_share_it(self):
        for port in (BASE_PORT, BASE_PORT + 1):
            with self.subTest(port=port), held(port):
                self.assertEqual(participant()[0], 1)
                what, advice = self.only("problem", "ports", *self.words)
                self.assertIn(f"UDP port {port} of DDS domain 4 is held by test_domain.py "
                              f"(pid {os.getpid()}), which does not share it", what)
                self.assertIn("Stop that program, or choose another domain: --domain 5", advice)

    def test_ports_that_the_system_gives_to_any_program(self):
        what, advice = self.only("note", "ports", "--domain", "150")
        self.assertRegex(what, r"^UDP ports 44900 to 45037 of DDS domain 150 are among those")
        self.assertEqual(advice, "Choose a domain below 101.")

    def test_no_participant_index_is_left(self):
        with held(*range(BASE_PORT + 10, BASE_PORT + 10 + 128)):
            self.assertEqual(participant()[0], 1)
            what, advice = self.only("problem", "ports", *self.words)
        self.assertEqual(what, "none of 64 participant indices of DDS domain 4 are left: "
                               f"test_domain.py (pid {os.getpid()}) has 64")
        self.assertIn("--domain 5", advice)

    def test_too_few_participant_indices_for_a_stack(self):
        with held(*range(BASE_PORT + 10, BASE_PORT + 10 + 120)):
            self.assertEqual(participant()[0], 0)
            what, _ = self.only("problem", "ports", *self.words)
        self.assertTrue(what.startswith("4 of 64 participant indices"), what)


if __name__ == "__main__":
    case.main()
