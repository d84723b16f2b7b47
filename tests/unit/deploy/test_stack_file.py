"""stack.yaml: what is read, and the one line of every mistake."""

import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import jsonschema
import yaml
from fake_stack import SCARAB, SOURCE_ROOT, STACK
from launcher.failure import ConfigError, UsageError
from launcher.stack import Restart
from launcher.stack_declaration import stack_schema
from launcher.stack_file import read_stack

REPOSITORY_FILE = SOURCE_ROOT / "deploy" / "stack.yaml"


class StackFile(unittest.TestCase):
    def read(self, text, profile="sim"):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "stack.yaml"
            file.write_text(text)
            return read_stack(file, profile, Path("/root-of-tree"))

    def mistake(self, text):
        """`line:col: key: reason` of the mistake in the text."""
        with self.assertRaises(ConfigError) as caught:
            self.read(text)
        line = str(caught.exception)
        self.assertNotIn("\n", line)
        match = re.fullmatch(r".*/stack\.yaml:(\d+:\d+: .*)", line)
        self.assertIsNotNone(match, line)
        return match[1]

    def test_repository_file(self):
        stack = read_stack(REPOSITORY_FILE, "sim", SOURCE_ROOT)
        self.assertEqual([s.name for s in stack.services],
                         ["logger", "plant", "supervisor", "premotor"])
        self.assertEqual(stack.expected(), "logger=1,plant=1,supervisor=1,premotor=1")
        self.assertIs(stack.service("plant").restart, Restart.BETWEEN_TRIALS)
        self.assertEqual(stack.service("plant").config, SOURCE_ROOT / "config/plant/beetle.yaml")

    def test_instances_are_processes_with_names_of_their_own(self):
        stack = self.read(STACK.replace("scarab-premotor, instances: 1",
                                        "scarab-premotor, instances: 2"))
        self.assertEqual([p.name for p in stack.processes()],
                         ["logger", "plant", "premotor", "premotor-1"])
        self.assertEqual(stack.expected(), "logger=1,plant=1,premotor=2")

    def test_unknown_key(self):
        self.assertEqual(self.mistake(STACK.replace("log_level", "log_levl")),
                         "3:1: log_levl: unknown key (did you mean 'log_level'?)")
        self.assertEqual(self.mistake(STACK.replace("plant: {binary", "plant: {binaries")),
                         "8:11: services.plant.binaries: unknown key (did you mean 'binary'?)")

    def test_duplicate_key(self):
        self.assertEqual(self.mistake(STACK + "log_level: info\n"), "12:1: log_level: duplicate key")
        self.assertEqual(self.mistake(STACK.replace("  plant:", "  logger:")),
                         "8:3: services.logger: duplicate key")

    def test_missing_key(self):
        self.assertEqual(self.mistake(STACK.replace("log_level: info", "")),
                         "2:1: log_level: missing key")

    def test_wrong_types_and_ranges(self):
        for old, new, reason in (
                ("ready_s: 20", "ready_s: soon", "expected a number, found a text 'soon'"),
                ("ready_s: 20", "ready_s: .nan", "expected a finite number, found '.nan'"),
                ("ready_s: 20", "ready_s: 0", "0 is out of range [0.1, 600]"),
                ("plant, instances: 1", "plant, instances: 1.5", "expected an integer"),
                ("plant, instances: 1", "plant, instances: 0", "0 is out of range [1, 8]"),
                ("plant, instances: 1", "plant, instances: 010", "expected a decimal integer"),
                ("plant, instances: 1", "plant, instances: yes", "expected an integer"),
                ("tick_master: true", "tick_master: yes", "expected true or false, found 'yes'"),
                ("plant, instances: 1", "plant, instances: 2", "must be 1: the tick master has"),
                ("stop_s: 20}\nprof", "stop_s: 20, tick_master: true}\nprof", "has 2 tick masters"),
                ("binary: scarab-plant", "config: 'x/{robot}', binary: y", "has no key 'robot'"),
                ("[logger, plant, premotor]}", "[plant], elsewhere: [plant]}", "both here and else"),
                ("log_level: info", "log_level: inf", "did you mean 'info'?"),
                ("binary: scarab-plant", "binary: bin/scarab-plant", "is a path"),
                ("binary: scarab-plant", "binary: ''", "must not be empty"),
                ("restart: between_trials", "restart: sometimes", "one of always"),
                ("bus: {interface: lo, tag: \"\"}", "bus: lo", "expected a mapping"),
                ("services: [logger, plant, premotor]", "services: []", "at least one"),
                ("services: [logger, plant, premotor]", "services: logger", "expected a list"),
                ("services: [logger, plant, premotor]", "services: [plant, logger]", "order"),
                ("services: [logger, plant, premotor]", "services: [plnt]", "did you mean 'plant'?"),
                ("services: [logger, plant, premotor]", "services: [plant, plant]", "twice")):
            with self.subTest(new=new):
                self.assertIn(old, STACK)
                self.assertIn(reason, self.mistake(STACK.replace(old, new)))

    def test_what_is_said_of_devices_and_hardware(self):
        text = STACK.replace("tick_master: true", "tick_master: true, device: true").replace(
            "  premotor:", "  box: {binary: scarab-box, hardware: true, instances: 1, restart: always, stop_s: 1}\n"
            "  premotor:") + "  other: {services: [plant], emulated: [box]}\n"
        self.assertEqual([s.name for s in self.read(text, "other").services], ["plant"])
        for old, new, reason in (
                ("emulated: [box]", "emulated: [premotor]", "'premotor' is a service; expected one with `hardware"),
                ("emulated: [box]", "emulated: [bx]", "did you mean 'box'?"),
                ("[plant], emulated", "[premotor], emulated", "no tick master with `device: true` here"),
                ("[plant], emulated", "[plant, box], emulated", "'box' is hardware, and belongs under `emulated`"),
                ("hardware: true,", "hardware: true, config: x,", "services.box.config: is not of hardware"),
                ("hardware: true,", "hardware: true, tick_master: true,", "tick_master: is not of hardware"),
                ("hardware: true, instances: 1", "hardware: true, instances: 2", "must be 1: the tick master has"),
                ("device: true", "device: true, plant: x", "services.plant.plant: is of hardware alone"),
                ("device: true", "device: true, paces: []", "must name at least one"),
                ("device: true", "device: true, paces: [fast]", "one of lockstep, realtime"),
                ("tick_master: true, device", "device", "services.plant.device: is of the tick master alone"),
                ("tick_master: true, device: true", "paces: [realtime]", "paces: is of the tick master alone"),
                ("binary: scarab-plant", "config: 'x/{driver}', binary: y", "has no key 'driver'")):
            with self.subTest(new=new):
                self.assertIn(old, text)
                self.assertIn(reason, self.mistake(text.replace(old, new)))

    def test_what_is_no_yaml(self):
        self.assertIn("not valid YAML", self.mistake("bus: [lo"))
        self.assertIn("not valid YAML", self.mistake("bus: \x01"))
        self.assertIn("is empty", self.mistake("# nothing\n"))
        with self.assertRaisesRegex(ConfigError, "absent.yaml:1:1: file: cannot be read"):
            read_stack(Path("/absent.yaml"), "sim", SOURCE_ROOT)

    def test_profile_that_is_not_there(self):
        with self.assertRaisesRegex(UsageError, "no profile 'simm' .did you mean 'sim'"):
            self.read(STACK, "simm")


class Schema(unittest.TestCase):
    """For editors: written from the declaration that the reader itself uses."""

    schema = json.loads(stack_schema())

    def accepts(self, text):
        return jsonschema.Draft7Validator(self.schema).is_valid(yaml.safe_load(text))

    def test_file_is_current(self):
        file = SOURCE_ROOT / "config" / "schema" / "stack.json"
        printed = subprocess.run([str(SCARAB), "config", "schema", "stack"], check=True,
                                 capture_output=True, text=True).stdout
        self.assertEqual(file.read_text(), printed,
                         "deploy/scarab config schema stack > config/schema/stack.json")

    def test_takes_what_the_reader_takes(self):
        jsonschema.Draft7Validator.check_schema(self.schema)
        self.assertTrue(self.accepts(STACK))
        self.assertTrue(self.accepts(REPOSITORY_FILE.read_text()))

    def test_refuses_what_the_reader_refuses_for_its_shape(self):
        for old, new in (("log_level", "log_levl"), ("log_level: info", ""), ("ready_s: 20", "ready_s: 0"),
                         ("ready_s: 20", "ready_s: soon"), ("plant, instances: 1", "plant, instances: 9"),
                         ("tick_master: true", "tick_master: 1"), ("  plant:", "  Plant:"),
                         ("binary: scarab-plant", "binary: bin/scarab-plant"),
                         ("restart: between_trials", "restart: sometimes"),
                         ("[logger, plant, premotor]", "[]"), ("interface: lo", "interface: ''")):
            with self.subTest(new=new):
                self.assertIn(old, STACK)
                self.assertFalse(self.accepts(STACK.replace(old, new)))

    def test_every_key_says_what_it_is(self):
        def keys(schema, path):
            for name, part in schema.get("properties", {}).items():
                yield f"{path}.{name}", part
                yield from keys(part, f"{path}.{name}")
                yield from keys(part.get("additionalProperties") or {}, f"{path}.{name}.*")

        for path, part in keys(self.schema, "stack"):
            self.assertTrue(part.get("description") or part["type"] == "object", path)


if __name__ == "__main__":
    unittest.main()
