"""Two sides that do not meet: other domains, other interfaces, other tags, other hosts."""

import subprocess

import case
from case import StackCase, sh

TOPIC = ("--topic", "scarab/operator")


class Sides(StackCase):
    """A running stack on loopback, and somebody who stands apart."""

    def test_everybody_is_there(self):
        self.odd_endpoint(*TOPIC)
        self.assertEqual([f[1] for f in self.doctor("sides", "endpoints", "domain")], ["ok"] * 3)

    def test_topics_of_the_stack_on_another_domain(self):
        self.odd_endpoint(*TOPIC, domain=9)
        what, advice = self.only("problem", "sides")
        self.assertRegex(what, r"^odd_endpoint \(pid \d+\) is on DDS domain 9, the stack on 4: they do "
                               r"not meet, though it has topics of the stack \(scarab/\.\.\.\)$")
        self.assertIn("Start it with --domain 4", advice)

    def test_program_on_another_domain_that_may_have_nothing_to_do_with_it(self):
        self.odd_endpoint("--topic", "somebodys/topic", domain=9)
        what, advice = self.only("note", "sides")
        self.assertRegex(what, r"^odd_endpoint \(pid \d+\) is on DDS domain 9, the stack on 4")
        self.assertIn("start it on domain 4", advice)

    def test_another_interface(self):
        self.two_interfaces()
        self.odd_endpoint(*TOPIC, "--interface", "v0")
        what, advice = self.only("problem", "sides")
        self.assertRegex(what, r"^odd_endpoint \(pid \d+\) is on DDS domain 4 by interface v0, the stack "
                               r"by lo: they do not meet$")
        self.assertIn("--interface lo", advice)

    def test_another_discovery_tag(self):
        self.odd_endpoint(*TOPIC, "--tag", "mine")
        what, advice = self.only("note", "sides")
        self.assertRegex(what, r"^odd_endpoint \(pid \d+\) is on DDS domain 4 and interface lo, but does "
                               "not answer: it has another discovery tag")
        self.assertIn("the stack's tag (none)", advice)

    def test_two_stacks_are_two_stacks(self):
        self.up(domain=5)
        self.assertNotIn("problem", [f[1] for f in self.doctor("domain", "sides", "endpoints")])
        other_tree = self.folder / "theirs"
        self.up(domain=6, runs=other_tree)
        self.assertEqual([f[1] for f in self.doctor("sides")], ["ok"])


class OtherHost(StackCase):
    """Somebody on another host of the network, while the stack has stayed on loopback."""

    def test_host_that_only_another_interface_sees(self):
        host = self.start(["unshare", "--net", "--uts", "sh", "-c",
                           "ip link set lo up && hostname meadow && echo there && read end"])
        there = ("nsenter", "--target", str(host.pid), "--net", "--uts")
        sh(f"ip link add w0 type veth peer name w1 && ip link set w1 netns {host.pid}")
        sh("ip address add 10.8.0.1/24 dev w0 && ip link set w0 up")
        sh(" ".join(there) + " sh -c 'ip address add 10.8.0.2/24 dev w1 && ip link set w1 up'")
        self.odd_endpoint(*TOPIC, "--interface", "w1", "--service", "operator", before=there)
        what, advice = self.only("problem", "sides")
        self.assertRegex(what, r"^operator/0 \(odd_endpoint, pid \d+ on meadow\) is seen by interface "
                               r"w0, the stack is on lo: they do not meet$")
        self.assertIn("--interface w0", advice)


if __name__ == "__main__":
    case.main()
