"""`scarab pause`, `stop`, `estop`, ...: to which stack, and with which words."""

import unittest

from fake_stack import FakeStackTest


class Operator(FakeStackTest):
    domain = 190

    def setUp(self):
        super().setUp()
        Operator.domain += 2
        self.domains = (str(Operator.domain), str(Operator.domain + 1))

    def up(self, domain, *words):
        code, out, err = self.scarab("up", "--domain", domain, *words)
        self.assertEqual(code, 0, out + err)

    def said(self):
        return (self.bin / "scarab-operator.command").read_text().split("\n")

    def test_each_says_its_word_with_its_reason_to_the_stack_that_is_up(self):
        self.up(self.domains[0], "--tag", "mine")
        for verb in ("start", "pause", "step", "stop", "estop", "reset"):
            with self.subTest(verb=verb):
                self.assertEqual(self.scarab(verb, "--reason", "two words")[0], 0)
                bus = ["--domain", self.domains[0], "--tag", "mine", "--interface", "lo"]
                self.assertEqual(self.said(), [*bus, verb, "--reason", "two words"])
        self.assertEqual(self.scarab("step", "5")[0], 0)
        self.assertEqual(self.said()[-2:], ["step", "5"])

    def test_refusal_is_the_exit_code(self):
        self.up(self.domains[0])
        self.order("scarab-operator", "exit-code", "1")
        for verb in ("pause", "estop"):
            self.assertEqual(self.scarab(verb)[0], 1)

    def test_emergency_stop_goes_to_all_stacks_the_others_ask_which(self):
        for domain in self.domains:
            self.up(domain)
        code, _, err = self.scarab("stop")
        self.assertEqual(code, 1)
        self.assertIn(f"stacks run on the domains {', '.join(self.domains)}: say which", err)
        self.assertEqual(self.scarab("estop")[0], 0)
        told = (self.bin / "scarab-operator.domains").read_text().split()
        self.assertEqual(sorted(told), sorted(self.domains))
        self.assertEqual(self.scarab("stop", "--domain", self.domains[1])[0], 0)
        self.assertIn(self.domains[1], self.said())
        for domain in self.domains:
            self.assertEqual(self.scarab("down", "--domain", domain)[0], 0)

    def test_without_a_stack_it_says_so(self):
        for verb in ("pause", "estop"):
            code, _, err = self.scarab(verb, "--domain", self.domains[0])
            self.assertEqual(code, 1)
            self.assertIn(f"no stack of this source tree is running on DDS domain {self.domains[0]}", err)


if __name__ == "__main__":
    unittest.main()
