"""The schemas that are shipped: those the program prints, and the ones that the files name."""

import unittest

from jsonschema import Draft7Validator

from config_program import CONFIG, KINDS, REGENERATE, SCHEMAS, SHIPPED, kind_of, scarab_config, schema_of
from mutation import places

OTHERS = {"stack", "experiment", "search"}  # whose own tests hold them against their programs
UNIT_WORDS = {"m", "s", "s2", "rad", "kg", "m2", "n", "nm", "hz", "ns", "ticks"}


class Schema(unittest.TestCase):
    def test_committed_is_what_the_program_prints(self):
        self.assertEqual({file.stem for file in SCHEMAS.iterdir()}, {*KINDS, *OTHERS})
        for kind in KINDS:
            code, out, err = scarab_config("schema", kind)
            self.assertEqual((code, err), (0, ""))
            self.assertEqual((SCHEMAS / f"{kind}.json").read_text(), out, f"{kind}.json is of before; {REGENERATE}")

    def test_is_a_schema(self):
        for kind in KINDS:
            Draft7Validator.check_schema(schema_of(kind))

    def test_every_shipped_file_names_its_schema_to_editors(self):
        self.assertEqual({kind_of(file) for file in SHIPPED}, set(KINDS))
        for file in SHIPPED:
            line = f"# yaml-language-server: $schema=../schema/{kind_of(file)}.json"
            self.assertEqual(file.read_text().splitlines()[0], line, f"the first line of {file.relative_to(CONFIG)}")

    def test_tells_the_unit_of_every_key_whose_name_has_one(self):
        count = 0
        for kind in KINDS:
            for path, part in places(schema_of(kind)):
                if len(path) < 2 or path[-2] != "properties" or not isinstance(part, dict):
                    continue
                if path[-1].rpartition("_")[2] in UNIT_WORDS and "_" in path[-1] and part.get("type") != "object":
                    count += 1
                    self.assertRegex(part.get("description", ""), r"^[A-Za-z]", f"{kind}: {path[-1]}")
        self.assertGreater(count, 50)


if __name__ == "__main__":
    unittest.main()
