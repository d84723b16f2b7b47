"""--replicas, --robot, --config, --interface, --realtime, --lockstep: what the services are started with."""

import tempfile
import unittest
from pathlib import Path

import yaml
from fake_stack import SOURCE_ROOT, FakeStackTest, wait_until
from launcher.failure import UsageError
from launcher.stack import LOGGER
from launcher.stack_changes import StackChanges
from launcher.stack_file import read_stack

SHIPPED = SOURCE_ROOT / "deploy" / "stack.yaml"


class Changes(FakeStackTest):
    domain = 100

    def setUp(self):
        super().setUp()
        Changes.domain += 1
        self.words = ("--domain", str(Changes.domain))

    def record(self):
        return yaml.safe_load((self.run_directory() / "config" / "run.yaml").read_text())

    def up(self, *words):
        code, out, err = self.scarab("up", *self.words, *words)
        self.assertEqual(code, 0, out + err)
        return out

    def test_up_goes_by_the_wall_clock_and_run_in_lockstep_unless_told_otherwise(self):
        for verb, option, pace in (("up", None, "realtime"), ("up", "--lockstep", "lockstep"),
                                   ("run", None, "lockstep"), ("run", "--realtime", "realtime")):
            with self.subTest(verb=verb, option=option):
                self.assertEqual(self.scarab(verb, *self.words, *([option] if option else []))[0], 0)
                self.assertEqual(self.command_of("scarab-plant")["--pace"], pace)
                self.assertNotIn("--pace", self.command_of("scarab-premotor"))
                self.assertEqual(self.record()["pace"], pace)
                self.scarab("down", *self.words)

    def test_run_takes_the_pace_of_the_stack_that_is_up_and_says_so(self):
        self.assertIn("in lockstep", self.up("--lockstep"))
        for words in ([], ["--lockstep"]):
            code, out, err = self.scarab("run", *self.words, *words)
            self.assertEqual(code, 0, err)
            self.assertIn("in lockstep", out)
        code, _, err = self.scarab("run", *self.words, "--realtime")
        self.assertEqual(code, 2)
        self.assertRegex(err, "the stack that is up goes in lockstep.*up --realtime")

    def test_run_refuses_to_change_a_stack_that_is_up(self):
        self.up()
        for words in (["--replicas", "premotor=2"], ["--robot", "beetle"], ["--profile", "sim"],
                      ["--config", "plant=x.yaml"], ["--tag", "other"], ["--interface", "eth7"], ["--no-log"]):
            with self.subTest(words=words):
                code, _, err = self.scarab("run", *self.words, *words)
                self.assertEqual(code, 2, err)
                self.assertIn(f"{words[0]}: there is a stack up", err)
        self.assertEqual(self.scarab("run", *self.words, "--interface", "lo")[0], 0)

    def test_replicas_are_started_expected_and_recorded(self):
        self.up("--replicas", "premotor=3", "--replicas", "logger=1")
        self.assertEqual(self.command_of("scarab-plant")["--expect"], "logger=1,plant=1,premotor=3")
        instances = [line for line in self.living() if "scarab-premotor" in line]
        self.assertEqual(len(instances), 3)
        self.assertEqual(self.record()["services"]["premotor"]["instances"], 3)

    def test_interface_and_tag_are_handed_on(self):
        self.up("--interface", "eth7", "--tag", "mine")
        command = self.command_of("scarab-premotor")
        self.assertEqual((command["--interface"], command["--tag"]), ("eth7", "mine"))
        self.assertEqual(self.record()["bus"]["interface"], "eth7")

    def test_another_file_takes_the_place_of_the_services_own(self):
        own, other = self.folder / "own.yaml", self.folder / "other.yaml"
        for file in (own, other):
            file.write_text("x: 1\n")
        self.stack_file.write_text(self.stack_file.read_text().replace(
            "binary: scarab-plant,", f"binary: scarab-plant, config: {own},"))
        for words, file in (([], own), (["--config", f"plant={other}"], other)):
            self.assertEqual(self.scarab("run", *self.words, *words)[0], 0)
            self.assertEqual(self.command_of("scarab-plant")["--config"], str(file))
            self.assertTrue(self.record()["services"]["plant"]["config"].endswith(file.name))
        self.assertIn(f"--config plant={other}", self.record()["command"])

    def test_what_cannot_be_is_one_line_and_starts_nothing(self):
        for words, reason in (
                (["--replicas", "plnt=2"], "starts no service 'plnt' .did you mean 'plant'"),
                (["--replicas", "plant=2"], "just one of it"),
                (["--replicas", "premotor=9"], "out of range"),
                (["--replicas", "premotor"], "is not SERVICE=N"),
                (["--replicas", "premotor=2,premotor=2"], "named twice"),
                (["--config", "logger=/etc/hostname"], "takes no configuration file"),
                (["--config", "plant"], "is not SERVICE=FILE"),
                (["--robot", "beetel"], "unknown robot 'beetel' .did you mean 'beetle'")):
            with self.subTest(words=words):
                code, out, err = self.scarab("up", *self.words, *words)
                self.assertEqual((code, out), (2, ""), err)
                self.assertRegex(err, reason)
                self.assertEqual(len(err.splitlines()), 1, err)
        self.assertFalse(self.runs.exists())

    def test_unknown_strategy_is_found_before_and_on_a_stack_that_is_up(self):
        self.stack_file.write_text(self.stack_file.read_text().replace(
            "profiles:", "  supervisor: {binary: scarab-supervisor, config: x.yaml, instances: 1, "
            "restart: always, stop_s: 20}\nprofiles:").replace(
                "[logger, plant, premotor]", "[logger, plant, premotor, supervisor]"))
        for prepare in (lambda: None, self.up):
            prepare()
            code, _, err = self.scarab("run", *self.words, "--strategy", "sofd")
            self.assertEqual(code, 2, err)
            self.assertIn("did you mean 'soft'?", err)
            self.assertIn("soft, soft+hard", err)
        self.assertEqual(self.scarab("run", *self.words, "--strategy", "soft+hard")[0], 0)


class Robots(unittest.TestCase):
    """`{robot}` in the shipped file."""

    def read(self, **changes):
        return read_stack(SHIPPED, "sim", SOURCE_ROOT, StackChanges(**changes))

    def test_every_described_robot_has_all_its_files(self):
        for file in (SOURCE_ROOT / "config" / "robot").glob("*.yaml"):
            with self.subTest(robot=file.stem):
                stack = self.read(robot=file.stem)
                self.assertEqual(stack.robot, file.stem)
                files = {p for s in stack.services for p in (s.robot, s.config)
                         if p and s.name != LOGGER}  # which knows no robot
                self.assertEqual({p.stem for p in files}, {file.stem})
                self.assertTrue(all(p.is_file() for p in files))

    def test_robot_without_a_file_for_a_service_is_named(self):
        text = SHIPPED.read_text().replace("config/premotor/{robot}", "config/premotor/no-{robot}")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "stack.yaml"
            file.write_text(text)
            with self.assertRaisesRegex(UsageError, "has no config/premotor/no-beetle.yaml, which "
                                                    "service premotor reads"):
                read_stack(file, "sim", SOURCE_ROOT)


class TwoHosts(FakeStackTest):
    domain = 120

    def setUp(self):
        super().setUp()
        TwoHosts.domain += 1
        self.words = ("--domain", str(TwoHosts.domain))
        text = self.stack_file.read_text()
        self.stack_file.write_text(text.replace('tag: ""', 'tag: "", peers: [10.0.0.1, 10.0.0.2]') + """
  here: {services: [plant], elsewhere: [logger, premotor]}
  there: {services: [logger, premotor], elsewhere: [plant]}
""")

    def test_up_starts_its_own_and_says_whom_it_misses(self):
        code, out, err = self.scarab("up", *self.words, "--profile", "here")
        self.assertEqual(code, 0, err)
        self.assertEqual(len(self.living()), 1)
        self.assertIn("plant=1\n", out)
        self.assertIn("elsewhere: logger=1,premotor=1; not yet: logger, premotor is missing", out)
        self.assertIn("lo reaches no other host", out)
        command = self.command_of("scarab-plant")
        self.assertEqual(command["--expect"], "plant=1,logger=1,premotor=1")
        self.assertEqual(command["--peers"], "10.0.0.1,10.0.0.2")

    def test_up_says_when_all_are_there(self):
        for service in ("logger", "premotor"):
            (self.bin / f"up.{self.words[1]}.scarab-{service}").write_text("")
        code, out, err = self.scarab("up", *self.words, "--profile", "here")
        self.assertEqual(code, 0, err)
        self.assertIn("elsewhere: logger=1,premotor=1, all there", out)

    def test_file_elsewhere_cannot_be_changed_from_here_but_the_count_can(self):
        code, _, err = self.scarab("up", *self.words, "--profile", "here", "--config",
                                   "premotor=/etc/hostname")
        self.assertEqual(code, 2)
        self.assertIn("starts no service 'premotor'", err)
        self.assertEqual(self.scarab("up", *self.words, "--profile", "here", "--replicas",
                                     "premotor=2")[0], 0)
        self.assertTrue(self.command_of("scarab-plant")["--expect"].endswith("premotor=2"))

    def test_down_ends_what_this_host_has_started(self):
        self.assertEqual(self.scarab("up", *self.words, "--profile", "there")[0], 0)
        self.assertEqual(len(self.living()), 2)
        self.assertEqual(self.scarab("down", *self.words)[0], 0)
        wait_until(lambda: self.living() == [], "both have ended")


if __name__ == "__main__":
    unittest.main()
