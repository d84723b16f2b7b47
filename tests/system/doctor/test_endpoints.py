"""Writers and readers that do not fit together: the policy that differs, and who they are."""

import re

import case
from case import DOMAIN, TEST_PROGRAMS, StackCase

# Topic -> what its writer and its reader are told, and what the doctor says of it.
PAIRS = {
    "reliability": (["--best-effort"], [], "offered is best-effort, asked for is reliable",
                    "Let the writer offer reliable, or the reader ask for best-effort only."),
    "durability": (["--volatile"], [], "offered is volatile, asked for is transient-local",
                   "Let the writer offer transient-local, or the reader ask for volatile only."),
    "ownership": (["--exclusive"], [], "offered is exclusive, asked for is shared",
                  "Give both the same ownership: exclusive, or shared."),
    "deadline": (["--deadline-ms", "500"], ["--deadline-ms", "20"],
                 "offered is 500 ms, asked for is 20 ms",
                 "Let the writer promise a deadline of 20 ms or less"),
    "liveliness": ([], ["--lease-ms", "100"],
                   "offered is automatic, lease infinite, asked for is automatic, lease 100 ms",
                   "Let the writer offer automatic, lease 100 ms"),
    "partition": (["--partition", "field"], [], "offered is 'field', asked for is ''",
                  "Give both the same partition"),
    "type name": (["--type", "Trial"], [], "offered is scarab::Trial, asked for is scarab::Operator",
                  "Give both the same type"),
}


class Endpoints(StackCase):
    def test_every_policy_that_differs_is_named(self):
        for policy, (writer, reader, _, _) in PAIRS.items():
            topic = f"test/{policy.replace(' ', '_')}"
            self.odd_endpoint("--topic", topic, "--writes", *writer)
            self.odd_endpoint("--topic", topic, *reader)
        found = [f for f in self.doctor("endpoints") if f[1] == "problem"]
        self.assertEqual(len(found), len(PAIRS), found)
        for policy, (_, _, values, advice) in PAIRS.items():
            with self.subTest(policy=policy):
                what, given = next(f[2:] for f in found if f"their {policy} differs" in f[2])
                self.assertRegex(what, rf"^test/{policy.replace(' ', '_')}: odd_endpoint, pid \d+ on .+ "
                                       r"writes and odd_endpoint, pid \d+ on .+ reads it, but ")
                self.assertTrue(what.endswith(values), what)
                self.assertTrue(given.startswith(advice), given)

    def test_both_sides_are_named_by_service(self):
        self.odd_endpoint("--topic", "scarab/operator", "--writes", "--best-effort", "--service", "mine")
        for service in ("plant", "supervisor"):
            found = [f for f in self.doctor("endpoints") if f"{service}/0" in f[2]]
            self.assertEqual(len(found), 1, found)
            self.assertRegex(found[0][2], r"^scarab/operator: mine/0 \(odd_endpoint, pid \d+ on .+\) "
                             rf"writes and {service}/0 \(scarab-{service}, pid \d+ on .+\) reads it, "
                             "but their reliability differs")

    def test_two_policies_of_one_pair_are_two_problems(self):
        self.odd_endpoint("--topic", "test/both", "--writes", "--best-effort", "--volatile")
        self.odd_endpoint("--topic", "test/both")
        policies = {re.search("their (.+) differs", f[2])[1] for f in self.doctor("endpoints")}
        self.assertEqual(policies, {"reliability", "durability"})

    def test_program_built_from_another_version_of_the_idl(self):
        self.odd_endpoint("--topic", "test/version")
        self.environment["CYCLONEDDS_URI"] = \
            "<General><Interfaces><NetworkInterface name='lo' multicast='true'/></Interfaces></General>"
        self.start([TEST_PROGRAMS / "other_version", str(DOMAIN), "test/version"])
        del self.environment["CYCLONEDDS_URI"]
        found = [f for f in self.doctor("endpoints") if "their type differs" in f[2]]
        self.assertEqual(len(found), 1, found)
        self.assertIn('offered is one with "long field_of_another_version", asked for is one with "',
                      found[0][2])
        self.assertIn("build both from the same ones", found[0][3])

    def test_what_fits_is_no_problem(self):
        self.odd_endpoint("--topic", "test/well", "--writes", "--lease-ms", "100")
        self.odd_endpoint("--topic", "test/well", "--best-effort", "--volatile", "--lease-ms", "200")
        self.assertEqual([f[1] for f in self.doctor("endpoints")], ["ok"])


if __name__ == "__main__":
    case.main()
