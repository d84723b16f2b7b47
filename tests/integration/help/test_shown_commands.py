#!/usr/bin/python3
"""Commands that documents and help texts show: their verbs, commands and options exist."""

import functools
import os
import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
BIN = Path(os.environ["SCARAB_BIN"])
sys.path.insert(0, str(ROOT / "deploy"))

from launcher.cli import all_verbs  # noqa: E402
from launcher.syntax import syntax_of_parser  # noqa: E402
from launcher.tool_syntax import tool_syntax  # noqa: E402

FOLDERS = ("common", "config", "deploy", "docs", "idl", "services", "tests", "tools")
VERBS = all_verbs()
SHOWN = re.compile(r"(?<![\w/.-])(?:deploy/)?(scarab(?:-[a-z]+)?) +([^`\n]*)")
CODE = re.compile(r"`([^`\n]+)`")
END = {"|", "||", "&", "&&", ";", ">", "<", "(", ")", "<(", ">>"}


def commands_in(text):
    """[program, word...] of each command in a line of code."""
    found = []
    for match in SHOWN.finditer(text):
        lexer = shlex.shlex(match[2].partition("  #")[0], posix=True, punctuation_chars=True)
        lexer.whitespace_split, lexer.commenters, words = True, "", []
        try:
            for word in lexer:
                if word in END:
                    break
                words.append(word)
        except ValueError:  # a quote around the whole command ends with it
            pass
        found.append([match[1], *words])
    return found


def code_of(document):
    """Lines of code blocks, and code within the text."""
    fenced = False
    for line in document.splitlines():
        fenced ^= line.startswith("```")
        if fenced or line.startswith("    "):
            yield line
        else:
            yield from CODE.findall(line)


def stands_for_others(word):
    """NAME, N, {}, ... are to be replaced by the reader."""
    return not re.search(r"[a-z]", word) or "..." in word


@functools.lru_cache(maxsize=None)
def syntax_of(program, command):
    return tool_syntax(BIN / program, [command] if command else [])[0]


def fault_of(program, words):
    """What does not exist; empty where all does."""
    if program == "scarab":
        if not words or words[0].startswith("-") or stands_for_others(words[0]):
            return ""
        verb, *words = words
        if verb in VERBS.parsers:
            return options_fault(syntax_of_parser(VERBS.parsers[verb]), words)
        if verb not in VERBS.tools:
            return f"no verb {verb}"
        program = VERBS.tools[verb].program
        words = [word for word in words if word.partition("=")[0] not in VERBS.tools[verb].own]
    if not (BIN / program).exists():
        return f"no program {program}"
    whole = syntax_of(program, "")
    commands = whole.commands
    command = next((words[i] for i in whole.operands_among(words)), "")
    if commands and command and command not in commands:
        return "" if stands_for_others(command) else f"{program} has no command {command}"
    return options_fault(syntax_of(program, command if command in commands else ""), words)


def options_fault(syntax, words):
    for word in words:
        name = word.partition("=")[0]
        if re.match(r"--?[a-z]", name) and not (syntax.option(name) or name in ("-h", "--help")):
            return f"no option {name}"
    return ""


class ShownCommands(unittest.TestCase):
    def check(self, where, lines):
        count = 0
        for line in lines:
            for program, *words in commands_in(line):
                count += 1
                fault = fault_of(program, words)
                self.assertEqual(fault, "", f"{where}: {line.strip()}")
        return count

    def test_documents(self):
        files = [*ROOT.glob("*.md"), *(file for folder in FOLDERS for file in (ROOT / folder).rglob("*.md")
                                       if "node_modules" not in file.parts)]
        self.assertGreater(len(files), 20)
        count = 0
        for file in files:
            name = str(file.relative_to(ROOT))
            with self.subTest(file=name):
                count += self.check(name, code_of(file.read_text()))
        self.assertGreater(count, 100)

    def test_help_of_every_program_and_command(self):
        count = 0
        for program in sorted(file.name for file in BIN.glob("scarab-*")):
            for command in ["", *syntax_of(program, "").commands]:
                with self.subTest(program=program, command=command):
                    words = [str(BIN / program), *([command] if command else []), "--help"]
                    text = subprocess.run(words, capture_output=True, text=True, check=True).stdout
                    count += self.check(f"{program} {command}", text[text.find("xample"):].splitlines())
        self.assertGreater(count, 50)

    def test_help_of_every_verb(self):
        for verb, parser in VERBS.parsers.items():
            with self.subTest(verb=verb):
                text = parser.format_help()
                self.assertGreater(self.check(verb, text[text.find("example"):].splitlines()), 0)

    def test_mistakes_are_found(self):
        for line, fault in (("deploy/scarab upp", "no verb upp"), ("deploy/scarab up --reeltime", "no option --reeltime"),
                            ("deploy/scarab log frobnicate a.mcap", "scarab-log has no command frobnicate"),
                            ("x=$(deploy/scarab topic list --no-such)", "no option --no-such"),
                            ("scarab-log info a.mcap --no-such | head", "no option --no-such"),
                            ("scarab-nothing info", "no program scarab-nothing")):
            (program, *words), = commands_in(line)
            self.assertEqual(fault_of(program, words), fault)


if __name__ == "__main__":
    unittest.main()
