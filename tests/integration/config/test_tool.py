"""scarab-config as a user meets it: what it prints where, and its exit codes."""

import tempfile
import unittest
from pathlib import Path

from config_program import CONFIG, KINDS, SHIPPED, kind_of, read_yaml, scarab_config

BEETLE = CONFIG / "robot" / "beetle.yaml"


class Tool(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def assert_refused(self, *arguments, saying):
        """One line on stderr, nothing on stdout, exit code 2."""
        code, out, err = scarab_config(*arguments)
        self.assertEqual((code, out), (2, ""))
        self.assertEqual(err.count("\n"), 1, err)
        self.assertIn(saying, err)

    def test_check_looks_at_every_file(self):
        wrong = self.write("robot/wrong.yaml", f"extends: {BEETLE}\ntrunk: {{lenght_m: 1}}\n")
        missing = self.folder / "robot" / "none.yaml"
        code, out, err = scarab_config("check", wrong, BEETLE, missing)
        self.assertEqual(code, 2)
        self.assertEqual(out, f"{BEETLE}: ok\n")
        self.assertEqual(err.splitlines(), [
            f"{wrong}:2:9: trunk.lenght_m: unknown key; did you mean 'length_m'?",
            f"{missing}:1:1: (file): No such file or directory"])

    def test_check_finds_conditions_between_keys(self):
        wrong = self.write("robot/wrong.yaml", f"extends: {BEETLE}\nbackbone: {{servo: bakcbone}}\n")
        self.assert_refused("check", wrong, saying="wrong.yaml:2:19: backbone.servo: no servo 'bakcbone'")

    def test_the_folder_says_the_kind(self):
        code, out, _ = scarab_config("check", "beetle.yaml", folder=CONFIG / "plant")
        self.assertEqual((code, out), (0, "beetle.yaml: ok\n"))
        stray = self.write("stray.yaml", BEETLE.read_text())
        self.assert_refused("check", stray, saying="name one with --kind (calibration, logger, plant, premotor, robot, robot_bridge, supervisor)")
        self.assertEqual(scarab_config("check", stray, "--kind", "robot")[:2], (0, f"{stray}: ok\n"))
        self.assert_refused("check", stray, "--kind", "bird", saying="no kind 'bird'")

    def test_dump_is_the_whole_and_means_the_same(self):
        for file in SHIPPED:
            code, out, err = scarab_config("dump", file)
            self.assertEqual((code, err), (0, ""))
            self.assertNotIn("extends", read_yaml(out))
            dumped = self.write(f"{kind_of(file)}/dumped.yaml", out)
            self.assertEqual(scarab_config("diff", file, dumped), (0, "", ""))
            self.assertEqual(scarab_config("dump", dumped)[1], out)

    def test_dump_resolves_what_a_file_extends(self):
        stiff = self.write("robot/stiff.yaml", f"extends: {BEETLE}\n"
                           "servos: {leg: {kp_nm_rad: 30}}\nbackbone: absent\n")
        before, after = read_yaml(BEETLE.read_text()), read_yaml(scarab_config("dump", stiff)[1])
        before["servos"]["leg"]["kp_nm_rad"] = 30
        before["backbone"] = "absent"
        self.assertEqual(after, before)

    def test_diff_shows_values_whatever_file_they_stand_in(self):
        stiff = self.write("robot/stiff.yaml", f"extends: {BEETLE}\nservos: {{leg: {{kp_nm_rad: 30}}}}\n"
                           "legs: {hind: {attachment_m: [-0.2, 0.035, 0.0325]}}\n")
        code, out, err = scarab_config("diff", BEETLE, stiff)
        self.assertEqual((code, err), (1, ""))
        self.assertEqual(out.splitlines(), [
            f"servos.leg.kp_nm_rad: {read_yaml(BEETLE.read_text())['servos']['leg']['kp_nm_rad']:g} -> 30",
            "legs.hind.attachment_m: [-0.165, 0.035, 0.0325] -> [-0.2, 0.035, 0.0325]"])

    def test_diff_of_what_cannot_be_compared_is_trouble_not_a_difference(self):
        self.assert_refused("diff", BEETLE, CONFIG / "plant" / "beetle.yaml", saying="nothing to compare")
        self.assert_refused("diff", BEETLE, self.folder / "robot" / "none.yaml", saying="No such file")

    def test_match_takes_the_files_of_every_shipped_robot(self):
        robots = {file.stem for file in SHIPPED if kind_of(file) == "robot"}
        self.assertIn("beetle", robots)
        for robot in robots:
            files = [CONFIG / kind / f"{robot}.yaml" for kind in ("supervisor", "robot", "premotor", "plant")]
            self.assertEqual(scarab_config("match", *files), (0, "the files match\n", ""))

    def test_match_takes_every_robot_behind_its_bridge(self):
        bridges = [file for file in SHIPPED if kind_of(file) == "robot_bridge"]
        self.assertGreater(len(bridges), 3)
        for bridge in bridges:
            robot = bridge.stem.partition("-")[0]
            files = [bridge, *(CONFIG / kind / f"{robot}.yaml" for kind in ("robot", "plant"))]
            self.assertEqual(scarab_config("match", *files), (0, "the files match\n", ""), bridge)

    def test_match_finds_a_bridge_that_does_not_do_as_the_plant(self):
        robot, plant = (CONFIG / kind / "beetle.yaml" for kind in ("robot", "plant"))
        base = CONFIG / "robot_bridge" / "beetle-dynamixel.yaml"
        same = f"extends: {base}\ncalibration: {CONFIG}/calibration/beetle-dynamixel.yaml\n"
        for key, change in (("start.hind_rad", "start: {hind_rad: [0.6, -0.26, 1.23]}"),
                            ("timing.control_period_s", "timing: {control_period_s: 0.2}")):
            wrong = self.write("robot_bridge/wrong.yaml", f"{same}{change}\n")
            self.assertEqual(scarab_config("check", wrong)[0], 0, "alone there is nothing wrong with it")
            self.assert_refused("match", wrong, robot, plant, saying=f"{key}: differs from {plant}")
        wrong = self.write("robot_bridge/wrong.yaml", f"{same}start: {{backbone_rad: 1}}\n")
        self.assert_refused("match", wrong, robot, saying="start.backbone_rad: 1 is outside of the backbone joint's")

    def test_match_finds_servos_that_do_not_fit_the_robot(self):
        robot = CONFIG / "robot" / "beetle.yaml"
        base = CONFIG / "calibration" / "beetle-dynamixel.yaml"
        for change, saying in (("BJ: absent", "BJ: is absent, but the robot beetle has this joint"),
                               ("FL1: {offset_rad: 2.0, direction: -1, min_rad: 2.0, max_rad: 3.0}",
                                "FL1: is mounted so that the servo reaches nothing of the joint's range [0, 1.5")):
            wrong = self.write("calibration/wrong.yaml", f"extends: {base}\n{change}\n")
            self.assertEqual(scarab_config("check", wrong)[0], 0, "alone there is nothing wrong with it")
            self.assert_refused("match", wrong, robot, saying=saying)

    def test_match_takes_no_file_that_goes_with_any_robot(self):
        logger = CONFIG / "logger" / "default.yaml"
        self.assert_refused("match", logger, BEETLE, saying="files of kind logger go with any robot")

    def test_a_bridge_names_its_calibration_and_has_its_drivers_section(self):
        base = CONFIG / "robot_bridge" / "beetle-loopback.yaml"
        calibration = CONFIG / "calibration" / "beetle-loopback.yaml"
        for change, saying in (
                ("driver: dynamixl", "driver: expected one of amosii, dynamixel, loopback, found 'dynamixl'; did you mean 'dynamixel'?"),
                (f"driver: dynamixel\ncalibration: {calibration}", "dynamixel: is missing: the section of the driver"),
                ("calibration: none.yaml", f"calibration: there is no file {self.folder}/robot_bridge/none.yaml")):
            wrong = self.write("robot_bridge/wrong.yaml", f"extends: {base}\n{change}\n")
            self.assert_refused("check", wrong, saying=saying)

    def test_match_finds_what_no_single_file_can_tell(self):
        others = {kind: CONFIG / kind / "beetle.yaml" for kind in ("plant", "premotor", "robot", "supervisor")}
        f_offset_rad = read_yaml(others["premotor"].read_text())["motor"]["front"]["f_offset_rad"]
        for kind, key, change, saying in (
                ("plant", "start.middle_rad", "start: {middle_rad: [0.71, 0, 0]}",
                 "0.71 is outside of the middle thoraco-coxal joint's range [-0.698"),
                ("plant", "start.backbone_rad", "start: {backbone_rad: -1}", "-1 is outside of the backbone joint's"),
                ("premotor", "motor.hind.c_offset_rad", "motor: {hind: {c_offset_rad: 0.35}}",
                 "0.35 is outside of the hind coxa-trochanteral joint's range"),
                ("supervisor", "stationary_hind_pose_rad", "stationary_hind_pose_rad: [0, 0, -0.1]",
                 "-0.1 is outside of the hind femur-tibia joint's range [0, 1.5707963267948966] in "),
                ("supervisor", "as.reference_rad", "as: {reference_rad: 1.0}",
                 f"1 is not {f_offset_rad}, motor.front.f_offset_rad of {others['premotor']}")):
            with self.subTest(key=key):
                wrong = self.write(f"{kind}/wrong.yaml", f"extends: {others[kind]}\n{change}\n")
                self.assertEqual(scarab_config("check", wrong)[0], 0, "alone there is nothing wrong with it")
                files = {**others, kind: wrong}.values()
                self.assert_refused("match", *files, saying=f"{key}: {saying}")

    def test_match_asks_nothing_of_an_absent_joint(self):
        rigid = self.write("robot/rigid.yaml", f"extends: {BEETLE}\nbackbone: absent\n")
        plant = self.write("plant/bent.yaml", f"extends: {CONFIG}/plant/beetle.yaml\nstart: {{backbone_rad: 3}}\n")
        self.assertEqual(scarab_config("match", rigid, plant)[0], 0)

    def test_match_takes_one_file_of_a_kind(self):
        self.assert_refused("match", BEETLE, BEETLE, saying="both of kind robot")

    def test_schema_of_all_kinds_goes_to_a_folder(self):
        code, out, _ = scarab_config("schema", "--all", self.folder / "schema")
        self.assertEqual(code, 0)
        written = sorted((self.folder / "schema").iterdir())
        self.assertEqual(out.splitlines(), list(map(str, written)))
        self.assertEqual({file.name for file in written}, {f"{kind}.json" for kind in KINDS})
        code, _, err = scarab_config("schema", "--all", BEETLE)
        self.assertEqual((code, err.count("\n")), (1, 1), err)

    def test_bad_command_lines_are_one_line(self):
        for arguments in ([], ["dump"], ["diff", BEETLE], ["dump", BEETLE, BEETLE], ["check"], ["chek", BEETLE],
                          ["match", BEETLE], ["schema"], ["schema", "bird"], ["schema", "robot", "--all", "x"], ["check", "--no-such"]):
            with self.subTest(arguments=arguments):
                self.assert_refused(*arguments, saying="scarab-config: ")

    def test_every_subcommand_has_help_with_an_example(self):
        for arguments in ([], ["check"], ["dump"], ["diff"], ["match"], ["schema"]):
            code, out, err = scarab_config(*arguments, "--help")
            self.assertEqual((code, err), (0, ""))
            self.assertIn("Example: scarab-config ", out)


if __name__ == "__main__":
    unittest.main()
