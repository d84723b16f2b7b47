"""docs/commands.md: every verb is there, and every exit code of the launcher's table happens."""

import os
import re
import signal
import subprocess
import unittest

from experiment_case import EXPERIMENT
from fake_stack import SCARAB, SOURCE_ROOT, FakeStackTest, wait_until
from launcher.cli import all_verbs

PAGE = (SOURCE_ROOT / "docs" / "commands.md").read_text()
OPERATOR = ("start", "pause", "step", "stop", "estop", "reset")


def exit_codes():
    """{command: {code}} of the table; a dash is none."""
    table = {}
    for line in PAGE[PAGE.index("## Exit codes"):].splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" | ")]
        if re.fullmatch(r"`[a-z/ -]+`", cells[0]) and len(cells) == 5:
            codes = (0, 1, 2, 130)
            table[cells[0].strip("`")] = {c for c, cell in zip(codes, cells[1:]) if cell != "-"}
    return table


class Commands(FakeStackTest):
    domain = 168

    def setUp(self):
        super().setUp()
        Commands.domain += 1
        self.words = ("--domain", str(Commands.domain))
        config = self.folder / "any.yaml"
        config.write_text("")
        tiny = self.folder / "tiny.yaml"
        tiny.write_text(EXPERIMENT)
        self.tiny = (str(tiny), "--no-report", "--out", str(self.folder / "out"))
        text = self.stack_file.read_text()
        for name in ("plant", "premotor"):
            text = text.replace(f"scarab-{name},", f"scarab-{name}, config: {config}, robot: {config},")
        self.stack_file.write_text(text.replace(
            "profiles:", f"  supervisor: {{binary: scarab-supervisor, config: {config}, instances: 1, "
            "restart: always, stop_s: 20}\nprofiles:").replace(
                "[logger, plant, premotor]", "[logger, plant, premotor, supervisor]"))

    def code_of(self, verb, *words):
        return self.scarab(verb, *self.where(verb), *words)[0]

    def where(self, verb):
        return () if verb in ("sim", "completion", "experiment") else self.words

    def interrupted(self, verb, *words):
        """Ends the verb by Ctrl-C once a program of it runs."""
        launcher = self.start(verb, *self.where(verb), *words)
        wait_until(lambda: self.living() or launcher.poll() is not None, "something runs")
        os.kill(launcher.pid, signal.SIGINT)
        return self.finish(launcher)[0]

    def expect(self, verb, code, got):
        self.seen.setdefault(f"scarab {verb}", set()).add(code)
        self.assertEqual(got, code, f"scarab {verb}")

    def test_every_exit_code_of_the_launchers_table_happens_and_no_other_is_listed(self):
        self.seen = {}
        self.without_a_stack()
        self.expect("up", 0, self.code_of("up"))
        self.with_a_stack()
        self.expect("down", 0, self.code_of("down"))
        self.interruptions()
        self.assertEqual(self.seen, {command: codes for command, codes in exit_codes().items()
                                     if command.startswith("scarab ")})

    def without_a_stack(self):
        for verb in all_verbs().parsers:
            self.expect(verb, 2, self.code_of(verb, "--no-such-option"))
        for verb in (*OPERATOR, "status", "logs"):
            self.expect(verb, 1, self.code_of(verb))
        self.expect("completion", 0, self.code_of("completion", "bash"))
        self.order("scarab-experiment", "exit-code", "1")
        self.order("scarab-sim", "exit-code", "1")
        self.expect("run", 1, self.code_of("run"))
        self.expect("sim", 1, self.code_of("sim"))
        self.order("scarab-sim", "error", "100")
        self.expect("experiment", 1, self.code_of("experiment", *self.tiny))
        self.withdraw("scarab-sim", "error")
        self.expect("experiment", 0, self.code_of("experiment", *self.tiny))
        self.withdraw("scarab-experiment", "exit-code")
        self.withdraw("scarab-sim", "exit-code")
        self.expect("run", 0, self.code_of("run"))
        self.expect("sim", 0, self.code_of("sim"))
        self.order("scarab-premotor", "die-at-start")
        self.expect("up", 1, self.code_of("up"))
        self.withdraw("scarab-premotor", "die-at-start")

    def with_a_stack(self):
        for verb in (*OPERATOR, "status", "logs"):
            self.expect(verb, 0, self.code_of(verb))
        self.expect("doctor", 0, self.code_of("doctor", "leftovers"))
        (self.bin / "scarab-topic").chmod(0o644)
        self.expect("doctor", 1, self.code_of("doctor", "programs"))
        (self.bin / "scarab-topic").chmod(0o755)
        other = ("--domain", str(Commands.domain + 20))
        self.assertEqual(self.scarab("up", *other)[0], 0)
        self.expect("down", 1, self.scarab("down")[0])
        self.assertEqual(self.scarab("down", *other)[0], 0)

    def interruptions(self):
        self.order("scarab-status", "hold")
        self.expect("up", 130, self.interrupted("up"))
        self.expect("run", 130, self.interrupted("run"))
        self.withdraw("scarab-status", "hold")
        self.order("scarab-sim", "hold")
        self.expect("sim", 130, self.interrupted("sim"))
        self.expect("experiment", 130, self.interrupted("experiment", *self.tiny, "--fresh"))


class Page(unittest.TestCase):
    def test_every_verb_has_a_place_and_none_is_made_up(self):
        verbs = all_verbs()
        rows = re.findall(r"^\| (`.*?) \|", PAGE[:PAGE.index("## Exit codes")], re.MULTILINE)
        named = {word.split()[0] for row in rows for word in re.findall(r"`([^`]+)`", row)}
        for verb in (*verbs.parsers, *verbs.tools):
            self.assertIn(verb, named)
        for verb in re.findall(r"^\| `([a-z]+)", PAGE[:PAGE.index("## Exit codes")], re.MULTILINE):
            self.assertIn(verb, {*verbs.parsers, *verbs.tools})

    def test_every_verb_of_the_launcher_and_every_program_is_in_the_table(self):
        table = exit_codes()
        for verb in all_verbs().parsers:
            self.assertIn(f"scarab {verb}", table)
        for tool in all_verbs().tools.values():
            self.assertIn(tool.program, table)

    def test_options_it_names_exist(self):
        verbs = all_verbs()
        known = {option for parser in verbs.parsers.values() for action in parser._actions
                 for option in action.option_strings}
        page = re.sub(r"`(?:drive|replay|--wait)[^`]*`|scarab (?:log|topic) .*", "", PAGE)  # of compiled programs
        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", page):
            self.assertIn(option, known)

    def test_every_verb_has_help_with_an_example(self):
        for verb in all_verbs().parsers:
            with self.subTest(verb=verb):
                done = subprocess.run([str(SCARAB), verb, "--help"], capture_output=True, text=True,
                                      check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertRegex(done.stdout, rf"examples?:\n(  .*\n)*?  .*deploy/scarab {verb}")
                self.assertIn("exit codes:", done.stdout)
                self.assertLessEqual(max(map(len, done.stdout.splitlines())), 110)


if __name__ == "__main__":
    unittest.main()
