"""What the tests of the completion share: real shells, and a folder with tools that answer as the real ones do."""

import json
import os
import pty
import re
import select
import tempfile
import time
import unittest
from pathlib import Path

from fake_stack import SCARAB, SOURCE_ROOT

PATIENCE_S = 20.0
TOOL_HELP = """Looks at DDS topics of any type.
Usage: scarab-topic [OPTIONS] SUBCOMMAND

Options:
  -h,--help                   Print this help message and exit
  --domain UINT:UINT in [0 - 230]=0
                              DDS domain
  --no-fun{false}             none

Subcommands:
  list                        topics, their types, writers and readers
  echo, print                 print the samples of a topic as YAML

Examples:
  scarab-topic list --verbose
"""
LOG_HELP = """Looks into recorded logs (MCAP).
Usage: scarab-log [OPTIONS] SUBCOMMAND

Subcommands:
  info                        what a log holds: topics, trials, time span
  cat                         print samples as YAML
  diff                        whether two logs hold the same samples
"""
LOG_COMMAND_HELP = """print samples as YAML
Usage: scarab-log cat [OPTIONS] file

Positionals:
  file FILE ... REQUIRED      the log

Options:
  -n INT                      how many
  --topic TEXT ...            a topic
  --field TEXT ...            a column, or the beginning of several
  --output FILE               where to
  --trial UINT                only samples of this trial
"""
LOG_INFO = {"topics": [{"topic": "scarab/behaviour", "messages": 2}, {"topic": "rt/joint_states"}],
            "trials": [{"trial": 17}]}
COMMAND_HELP = """print the samples of a topic as YAML
Usage: scarab-topic echo [OPTIONS] topic

Positionals:
  topic TEXT REQUIRED         such as scarab/robot_state

Options:
  --json                      one line of JSON a sample
  --format TEXT:{yaml,json}=yaml
                              how it looks
  --field TEXT ...            a part of the sample
  --type TEXT                 of a topic that has no writer
"""

EMULATOR_HELP = """A robot to try the bridge on.
Usage: scarab-emulator [OPTIONS] [SUBCOMMAND]

Options:
  --device TEXT               link to the serial device

Subcommands:
  tell                        tells a running emulator to misbehave
"""
TELL_HELP = """tells a running emulator to misbehave
Usage: scarab-emulator tell [OPTIONS] where words...

Positionals:
  where TEXT REQUIRED         its run directory, or its control pipe
  words TEXT ... REQUIRED     the fault, such as: stuck TR0 for 2

Faults:
  stuck JOINT              the joint's servo does not move
  silent JOINT|imu|board   no answers
  clear                    none of these any more
  each may end with `at S` (since the world's t = 0) and `for S`
Examples:
  scarab-emulator tell runs/20261122-1 clear
"""


class Shell:
    """An interactive one with the completion loaded, in a terminal of its own."""

    commands = {
        "bash": (["--norc", "--noprofile", "-i"], [
            *(f"bind 'set {setting}'" for setting in (
                "show-all-if-ambiguous on", "page-completions off", "completion-query-items 0",
                "enable-bracketed-paste off")), "PS1="]),
        "zsh": (["-f", "-i"], [
            "PS1= PROMPT_EOL_MARK=; unset zle_bracketed_paste; bindkey -e; unsetopt list_ambiguous",
            "autoload -Uz compinit; compinit -u -D"]),
    }

    def __init__(self, name, folder, environment):
        options, settings = self.commands[name]
        self._pid, self._terminal = pty.fork()
        if self._pid == 0:
            os.chdir(folder)
            os.execve(f"/usr/bin/{name}", [name, *options],
                      {"PATH": "/usr/bin:/bin", "TERM": "dumb", "INPUTRC": "/dev/null",
                       "HOME": str(folder), **environment})
        self._read = ""
        for setting in settings:
            self.type(f"{setting}\n")
        self.type(f"source <({SCARAB} completion {name}); echo lo''aded\n")
        self._until("\nloaded")

    def after_tab(self, line):
        """The line as Tab leaves it."""
        self.type(f"{line}\t\x01echo '<'\x05'>'\n")  # start of line, end of line
        return self._until(r"\n<(.*)>\r").strip()

    def shows_at_tab(self, line, *candidates):
        """Waits until Tab has shown all of them; fails with what it has shown instead."""
        self.type(f"{line}\t")
        for word in candidates:
            self._until(rf"\s{re.escape(word)}\s", keep=True)
        self.forget()

    def forget(self):
        """Deletes the line, and skips what has been shown so far."""
        self.type("\x15echo '<''>'\n")
        return self._until(r"((?:.|\n)*)\n<>\r")

    def close(self):
        os.close(self._terminal)
        os.waitpid(self._pid, 0)

    def type(self, text):
        os.write(self._terminal, text.encode())

    def _until(self, pattern, keep=False):
        deadline = time.monotonic() + PATIENCE_S
        while not (match := re.search(pattern, self._read)):
            if not select.select([self._terminal], [], [], deadline - time.monotonic())[0]:
                raise AssertionError(f"no {pattern!r} in {self._read!r}")
            self._read += os.read(self._terminal, 65536).decode()
        self._read = self._read if keep else self._read[match.end():]
        return match[1] if match.groups() else ""


class Room(unittest.TestCase):
    """A folder with tools that have but a help, and with files to complete."""

    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = Path(room.name)
        (self.room / "bin").mkdir()
        self.program("scarab-topic", f"""case "$*" in
            *list*--names*) [ -f {self.room}/topics ] && cat {self.room}/topics || exec sleep 9 ;;
            *list*--json*) [ -f {self.room}/seen ] && cat {self.room}/seen || exec sleep 9 ;;
            "fields --names --name scarab::Behaviour"*) printf '%s\\n' header.tick mode ;;
            "fields --names rt/x --timeout "*) printf '%s\\n' stamp points.length ;;
            *echo*) cat <<'X'\n{COMMAND_HELP}\nX\n;;
            *) cat <<'X'\n{TOOL_HELP}\nX\n;; esac""")
        self.program("scarab-log", f"""case "$*" in
            *--help) [ $1 = --help ] && cat <<'X' || cat <<'Y'\n{LOG_HELP}\nX\n{LOG_COMMAND_HELP}\nY\n;;
            info*/trial.mcap*/trial-2.mcap.active\ --json) echo '{json.dumps(LOG_INFO)}' ;;
            export*/trial.mcap*/trial-2.mcap.active\ --topic\ scarab/behaviour*)
              echo 'header.tick,mode'; echo 1,2; exec sleep 9 ;;
            *) exit 2 ;; esac""")
        self.program("scarab-emulator", f"""case "$*" in
            tell*) cat <<'X'\n{TELL_HELP}\nX\n;;
            *) cat <<'X'\n{EMULATOR_HELP}\nX\n;; esac""")
        # The supervisor alone knows its strategies; this one says what is in its file.
        self.program("scarab-supervisor", 'while [ "$1" != --config ]; do shift; done; cat "$2"')
        (self.room / "deploy").symlink_to(SOURCE_ROOT / "deploy")
        (self.room / "my files").mkdir()
        (self.room / "plants").mkdir()
        (self.room / "plants" / "noisy.yaml").write_text("")
        run = self.room / "runs" / "2026-01-01-1"
        run.mkdir(parents=True)
        (run / "trial.mcap").write_text("")
        (run / "trial-2.mcap.active").write_text("")
        (self.room / "runs" / "latest").symlink_to(run.name)
        self.environment = {"SCARAB_BIN": str(self.room / "bin"),
                            "SCARAB_RUNS": str(self.room / "runs")}

    def program(self, name, body):
        file = self.room / "bin" / name
        file.write_text(f"#!/bin/sh\n{body}\n")
        file.chmod(0o755)
