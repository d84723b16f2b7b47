"""An independent validator with the shipped schemas, and the program's own reader: of one mind about every file."""

import functools
import re
import tempfile
import unittest
from pathlib import Path

import yaml
from jsonschema import Draft7Validator

import mutation
from config_program import CONFIG, SHIPPED, kind_of, read_yaml, scarab_config, schema_of

# Mutants are made of these, one of each kind. They extend no other file: what a mistake comes to would depend on it.
WHOLE = [file for file in SHIPPED if file.stem in ("beetle", "beetle-dynamixel")]
OUT_OF_RANGE = re.compile(r": \S+ is (not (in |above |at least |at most )|negative)")


def refused_by_schema(kind, content):
    return not validator_of(kind).is_valid(content)


@functools.lru_cache(maxsize=None)
def validator_of(kind):
    return Draft7Validator(schema_of(kind))


class SchemaAgrees(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        # A folder among folders like those of config/, in which a bridge's file names its calibration.
        self.folder = Path(folder.name) / "mutants"
        self.folder.mkdir()
        (self.folder.parent / "calibration").symlink_to(CONFIG / "calibration")

    def refusals(self, kind, contents):
        """What the program says of each content, or None; all in one process."""
        if not contents:
            return []
        files = [self.folder / f"{number}.yaml" for number in range(len(contents))]
        for file, content in zip(files, contents):
            file.write_text(yaml.dump(content, Dumper=yaml.CSafeDumper, sort_keys=False))
        _, out, err = scarab_config("check", "--kind", kind, *files)
        good = set(out.splitlines())
        bad = {line.partition(":")[0]: line for line in err.splitlines()}
        self.assertEqual(len(good) + len(bad), len(files), err)
        return [None if f"{file}: ok" in good else bad[str(file)] for file in files]

    def judged(self, kind, mutants):
        return zip(mutants, self.refusals(kind, [mutant.content for mutant in mutants]))

    def assert_both_refuse(self, make, least):
        count = 0
        for file in WHOLE:
            kind = kind_of(file)
            mutants = list(make(read_yaml(file.read_text()), schema_of(kind)))
            for mutant, refusal in self.judged(kind, mutants):
                with self.subTest(file=file.name, kind=kind, mutant=mutant.name):
                    self.assertTrue(refused_by_schema(kind, mutant.content), "the schema takes it")
                    self.assertIsNotNone(refusal, "the program takes it")
            count += len(mutants)
        self.assertGreaterEqual(count, least)

    def test_both_take_every_shipped_file(self):
        for file in SHIPPED:
            errors = list(validator_of(kind_of(file)).iter_errors(read_yaml(file.read_text())))
            self.assertEqual([error.message for error in errors], [], file)
        code, out, err = scarab_config("check", *SHIPPED)
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(out.splitlines(), [f"{file}: ok" for file in SHIPPED])

    def test_both_refuse_unknown_keys(self):
        self.assert_both_refuse(mutation.with_unknown_key, 50)

    def test_both_refuse_missing_keys(self):
        self.assert_both_refuse(mutation.without_key, 200)

    def test_both_refuse_wrong_types(self):
        self.assert_both_refuse(lambda content, _: mutation.of_wrong_type(content), 600)

    def test_both_refuse_wrong_sizes(self):
        self.assert_both_refuse(mutation.of_wrong_size, 30)

    def test_both_refuse_names_that_there_are_not(self):
        self.assert_both_refuse(mutation.with_other_name, 10)

    def test_both_have_the_same_limits(self):
        verdicts = {True: 0, False: 0}
        for file in WHOLE:
            kind = kind_of(file)
            mutants = list(mutation.with_other_number(read_yaml(file.read_text()), schema_of(kind)))
            for mutant, refusal in self.judged(kind, mutants):
                # Refusals for another reason come from conditions between keys, which a schema cannot say.
                by_program = OUT_OF_RANGE.search(refusal or "") is not None
                verdicts[by_program] += 1
                with self.subTest(file=file.name, kind=kind, mutant=mutant.name):
                    self.assertEqual(refused_by_schema(kind, mutant.content), by_program, refusal)
        self.assertGreater(min(verdicts.values()), 300)

    def extending(self, file, change):
        content = {"extends": str(file), **change}
        refusal, = self.refusals(kind_of(file), [content])
        return refused_by_schema(kind_of(file), content), refusal

    def test_a_file_that_extends_need_not_be_complete(self):
        for file in WHOLE:
            self.assertEqual(self.extending(file, {}), (False, None))
        beetle = next(file for file in WHOLE if kind_of(file) == "robot")
        part = {"servos": {"leg": {"kp_nm_rad": 12.5}}, "legs": {"hind": {"tibia": {"length_m": 0.1}}}}
        self.assertEqual(self.extending(beetle, part), (False, None))
        self.assertTrue(refused_by_schema("robot", part), "without `extends`")
        self.assertIsNotNone(self.refusals("robot", [part])[0])

    def test_a_file_that_extends_must_be_right_in_what_it_gives(self):
        beetle = next(file for file in WHOLE if kind_of(file) == "robot")
        for change in ({"servos": {"leg": {"kp": 1}}}, {"legs": {"hind": {"foot_radius_m": 0}}},
                       {"legs": {"hind": {"attachment_m": [0, 0]}}}, {"backbone": "none"}, {"legs": "absent"},
                       {"trunk": {"extends": str(beetle)}}):
            by_schema, by_program = self.extending(beetle, change)
            self.assertTrue(by_schema, change)
            self.assertIsNotNone(by_program, change)


if __name__ == "__main__":
    unittest.main()
