"""Two sides that do not meet: other domains, other interfaces, other tags, other hosts."""

import case
from case import DOMAIN, DoctorCase, StackCase, sh

TOPIC = ("--topic", "scarab/operator")


class Sides(StackCase):
    """A running stack on loopback, and somebody who stands apart."""

    def test_everybody_is_there(self):
        self.odd_endpoint(*TOPIC)
        self.assertEqual([f for f in self.doctor("sides", "endpoints", "domain") if f[1] != "ok"], [])

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


class OtherHost(DoctorCase):
    """Somebody on another host of the network 10.8.0.0/24, which this one is on by w0."""

    def setUp(self):
        super().setUp()
        host = self.start(["unshare", "--net", "--uts", "sh", "-c",
                           "ip link set lo up && hostname meadow && echo there && read end"])
        self.there = ("nsenter", "--target", str(host.pid), "--net", "--uts")
        sh("ip link add w0 type veth peer name w1")
        self.addCleanup(sh, "ip link delete w0")  # at once; with the namespace it goes some time later
        sh(f"ip link set w1 netns {host.pid}")
        sh("ip address add 10.8.0.1/24 dev w0 && ip link set w0 up")
        sh(" ".join(self.there) + " sh -c 'ip address add 10.8.0.2/24 dev w1 && ip link set w1 up'")

    def somebody_there(self, service, domain=DOMAIN):
        self.odd_endpoint(*TOPIC, "--interface", "w1", "--service", service, domain=domain,
                          before=self.there)

    def test_host_that_only_another_interface_sees(self):
        self.up()
        self.somebody_there("operator")
        what, advice = self.only("problem", "sides")
        self.assertRegex(what, r"^operator/0 \(odd_endpoint, pid \d+ on meadow\) is seen by interface "
                               r"w0, the stack is on lo: they do not meet$")
        self.assertIn("--interface w0", advice)

    def test_halves_of_a_stack_on_different_domains_until_they_meet(self):
        self.up("--profile", "plant-host", "--interface", "w0")
        self.somebody_there("premotor", domain=9)
        found = [f[2:] for f in self.doctor("sides") if f[1] == "problem"]
        self.assertEqual(len(found), 2, found)
        (others, firewalls), (premotor, domains) = sorted(found, key=lambda f: "premotor" in f[0])
        self.assertRegex(premotor, r"^premotor/0 \(odd_endpoint, pid \d+ on meadow\) is on DDS domain 9, "
                                   r"the stack that expects it on 4: they do not meet$")
        self.assertIn("same --domain", domains)
        self.assertEqual(others, "logger/0 and supervisor/0 are expected, but are not seen on DDS domain "
                                 "4 by interface w0")
        self.assertIn("let UDP ports 8400 to 8649 pass the firewalls of both", firewalls)
        for service in ("premotor", "supervisor", "logger"):
            self.somebody_there(service)
        self.assertEqual([f[1] for f in self.doctor("sides")], ["ok"])

    def test_domain_that_another_host_is_on(self):
        self.stack_with_interface("w0")
        self.somebody_there("plant")
        what, _ = self.only("note", "domain", "--domain", str(DOMAIN))
        self.assertRegex(what, r"but other DDS programs are: plant/0 \(odd_endpoint, pid \d+ on meadow\)$")


if __name__ == "__main__":
    case.main()
