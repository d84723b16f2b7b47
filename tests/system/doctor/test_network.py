"""Interfaces that are missing, down, without an address or without multicast."""

import case
from case import DoctorCase, sh


class Network(DoctorCase):
    def fault(self):
        return self.only("problem", "network")

    def test_loopback_is_well(self):
        self.assertEqual(self.doctor("network"),
                         [("network", "ok", "'lo' is up, its address is 127.0.0.1", "")])

    def test_missing_interface(self):
        self.stack_with_interface("eth7")
        what, advice = self.fault()
        self.assertEqual(what, "there is no network interface 'eth7'; there are: lo, v0, v1")
        self.assertRegex(advice, r"Set bus.interface in .*stack.yaml to one of them")

    def test_interface_that_is_down(self):
        self.stack_with_interface("v0")
        self.assertEqual(self.fault(), ("interface 'v0' is down", "As root: ip link set v0 up"))

    def test_interface_without_an_address(self):
        self.stack_with_interface("v0")
        self.two_interfaces()
        sh("ip address flush dev v0")
        what, advice = self.fault()
        self.assertEqual(what, "interface 'v0' has no IPv4 address")
        self.assertIn("ip address add", advice)

    def test_interface_whose_multicast_is_off(self):
        self.stack_with_interface("v0")
        self.two_interfaces()
        self.assertEqual(self.doctor("network")[0][1], "ok")
        sh("ip link set v0 multicast off")
        what, advice = self.fault()
        self.assertIn("no multicast on 'v0' (it is switched off)", what)
        self.assertIn("ip link set v0 multicast on", advice)

    def test_multicast_that_the_system_refuses_to_join(self):
        before = sh("cat /proc/sys/net/ipv4/igmp_max_memberships").strip()
        self.addCleanup(sh, f"echo {before} > /proc/sys/net/ipv4/igmp_max_memberships")
        sh("echo 0 > /proc/sys/net/ipv4/igmp_max_memberships")
        what, _ = self.fault()
        self.assertRegex(what, r"no multicast on 'lo' \(.+\), so that nobody is discovered")

    def test_loopback_that_is_down(self):
        self.addCleanup(sh, "ip link set lo up")
        sh("ip link set lo down")
        self.assertEqual(self.fault(), ("interface 'lo' is down", "As root: ip link set lo up"))
        self.stack_with_interface("v0")
        self.two_interfaces()
        what, advice = self.fault()
        self.assertIn("interface 'lo' is down: this machine cannot reach its own addresses", what)
        self.assertIn("ip link set lo up", advice)

    def test_peer_that_no_route_leads_to(self):
        text = self.stack_file.read_text()
        self.stack_file = self.folder / "stack.yaml"
        self.stack_file.write_text(text.replace("peers: []", "peers: [10.9.9.9]"))
        what, advice = self.fault()
        self.assertEqual(what, "the peer '10.9.9.9' cannot be reached from this host: Network is "
                               "unreachable")
        self.assertIn("bus.peers", advice)

    def test_peers_make_up_for_multicast(self):
        self.stack_with_interface("v0")
        text = self.stack_file.read_text()
        self.assertIn("peers: []", text)
        self.stack_file.write_text(text.replace("peers: []", "peers: [10.7.0.2]"))
        self.two_interfaces()
        sh("ip link set v0 multicast off")
        what, _ = self.only("note", "network")
        self.assertIn("bus.peers makes up for it", what)


if __name__ == "__main__":
    case.main()
