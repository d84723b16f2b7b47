"""Tab on a command line: in real shells, and the candidates behind it."""

import json
import os
import re
import resource
import subprocess
import time
import unittest

from completion_room import COMMAND_HELP, TOOL_HELP, Room, Shell
from fake_stack import SCARAB, SOURCE_ROOT
from launcher.cli import all_verbs
from launcher.completion import Completion
from launcher.completion_verb import ASK
from launcher.places import Places
from launcher.process_identity import ProcessIdentity
from launcher.run_directory import RunDirectory
from launcher.running_stack import Kind, RunningStack
from launcher.stack import Bus, Pace
from launcher.syntax import syntax_of_help

COMPLETED = (
    ("deploy/scarab stat", "deploy/scarab status"),
    ("deploy/scarab up --rea", "deploy/scarab up --realtime"),
    ("deploy/scarab run --strategy boxing+", "deploy/scarab run --strategy boxing+hard"),
    ("deploy/scarab run --strategy=boxing+", "deploy/scarab run --strategy=boxing+hard"),
    ("deploy/scarab run --goal tr", "deploy/scarab run --goal travel"),
    ("deploy/scarab up --profile plant", "deploy/scarab up --profile plant-host"),
    ("deploy/scarab up --config plant=pl", "deploy/scarab up --config plant=plants/"),
    ("deploy/scarab up --config plant=plants/", "deploy/scarab up --config plant=plants/noisy.yaml"),
    ("deploy/scarab up --replicas prem", "deploy/scarab up --replicas premotor="),
    ("deploy/scarab topic ec", "deploy/scarab topic echo"),
    ("deploy/scarab topic echo scarab/wo", "deploy/scarab topic echo scarab/world_state"),
    ("deploy/scarab topic echo --format j", "deploy/scarab topic echo --format json"),
    ("deploy/scarab topic echo --type scarab::Tr", "deploy/scarab topic echo --type scarab::Trial"),
    ("deploy/scarab topic echo --type scarab::Beh", "deploy/scarab topic echo --type scarab::Behaviour"),
    ("deploy/scarab topic echo scarab/behaviour --field h",
     "deploy/scarab topic echo scarab/behaviour --field header.tick"),
    ("deploy/scarab topic echo rt/x --field po", "deploy/scarab topic echo rt/x --field points.length"),
    ("deploy/scarab log di", "deploy/scarab log diff"),
    ("deploy/scarab log cat lat", "deploy/scarab log cat latest"),
    ("deploy/scarab log cat runs/2026-01-01-1/trial-", "deploy/scarab log cat runs/2026-01-01-1/trial-2.mcap.active"),
    ("deploy/scarab log cat latest --topic rt", "deploy/scarab log cat latest --topic rt/joint_states"),
    ("deploy/scarab log cat latest --trial 1", "deploy/scarab log cat latest --trial 17"),
    ("deploy/scarab log cat latest --topic scarab/behaviour -n 3 --field m",
     "deploy/scarab log cat latest --topic scarab/behaviour -n 3 --field mode"),
    ("deploy/scarab experiment transp", "deploy/scarab experiment transport_speed"),
    ("deploy/scarab experiment merge pl", "deploy/scarab experiment merge plants/"),
    ("deploy/scarab run --profile rob", "deploy/scarab run --profile robot"),
    ("deploy/scarab run --profile robot --emu", "deploy/scarab run --profile robot --emulated"),
    ("deploy/scarab up --profile robot --driver dyn", "deploy/scarab up --profile robot --driver dynamixel"),
    ("deploy/scarab up --profile robot --emulated --config emu",
     "deploy/scarab up --profile robot --emulated --config emulator="),
    ("deploy/scarab up --device /dev/nul", "deploy/scarab up --device /dev/null"),
    ("deploy/scarab emulator te", "deploy/scarab emulator tell"),
    ("deploy/scarab emulator tell lat", "deploy/scarab emulator tell latest"),
    ("deploy/scarab emulator tell latest sil", "deploy/scarab emulator tell latest silent"),
    ("deploy/scarab completion z", "deploy/scarab completion zsh"),
    ("WHO=me deploy/scarab dow", "WHO=me deploy/scarab down"))


class InShells(Room):
    def shell(self, name):
        shell = Shell(name, self.room, self.environment)
        self.addCleanup(shell.close)
        return shell

    def test_one_candidate_is_typed(self):
        for name in Shell.commands:
            shell = self.shell(name)
            for line, completed in COMPLETED:
                with self.subTest(shell=name, line=line):
                    self.assertEqual(shell.after_tab(line), completed)

    def test_several_are_shown(self):
        for name in Shell.commands:
            shell = self.shell(name)
            with self.subTest(shell=name):
                shell.shows_at_tab("deploy/scarab ", "up", "down", "run", "estop", "topic")
                shell.shows_at_tab("deploy/scarab run --strategy so", "soft", "soft+hard")
                shell.shows_at_tab("deploy/scarab topic echo --", "--json", "--domain")

    def test_nonsense_completes_to_nothing(self):
        shell = self.shell("bash")
        for line in ("deploy/scarab nonsense ", "deploy/scarab up --domain 'x", "deploy/scarab up x"):
            with self.subTest(line=line):
                shell.type(f"{line}\t")
                self.assertNotIn("Traceback", shell.forget())


class Candidates(Room):
    def setUp(self):
        super().setUp()
        self.completion = Completion(
            all_verbs(), Places(self.room / "bin", self.room / "runs", SOURCE_ROOT / "deploy/stack.yaml"))

    def texts(self, *words):
        return [c.text for c in self.completion.of(words)]

    def test_every_verb_of_the_help_is_offered(self):
        help_text = subprocess.run([str(SCARAB), "--help"], capture_output=True, text=True,
                                   check=True).stdout
        in_help = re.findall(r"^  ([a-z]+)  +", help_text, re.MULTILINE)
        self.assertEqual(self.texts(""), [*in_help, "--help"])

    def test_option_that_was_given_is_offered_again_only_where_it_may_be(self):
        offered = self.texts("up", "--robot", "beetle", "--config", "plant=x", "--")
        self.assertNotIn("--robot", offered)
        self.assertIn("--config", offered)

    def test_strategies_follow_the_robot(self):
        self.program("scarab-supervisor", 'case "$*" in *phantomx*) echo "strategies: {walk: {}}" ;; '
                     '*) echo "strategies: {roll: {}}" ;; esac')
        self.assertEqual(self.texts("run", "--robot", "phantomx", "--strategy", ""), ["walk"])
        self.assertEqual(self.texts("run", "--strategy", ""), ["roll"])

    def test_robots_are_those_described(self):
        described = sorted(f.stem for f in (SOURCE_ROOT / "config" / "robot").glob("*.yaml"))
        self.assertEqual(self.texts("run", "--robot", ""), described)

    def test_drivers_are_those_with_a_file_for_the_robot(self):
        described = sorted(f.stem.removeprefix("beetle-")
                           for f in (SOURCE_ROOT / "config" / "robot_bridge").glob("beetle-*.yaml"))
        self.assertIn("dynamixel", described)
        self.assertEqual(self.texts("run", "--driver", ""), described)
        self.assertEqual(self.texts("run", "--robot", "none", "--driver", ""), [])

    def test_faults_are_those_of_the_emulators_help(self):
        self.assertEqual(self.texts("emulator", "tell", "latest", ""), ["clear", "silent", "stuck"])
        self.assertEqual(self.texts("emulator", "tell", "latest", "stuck", ""), [])

    def test_help_of_a_tool_is_read(self):
        syntax = syntax_of_help(TOOL_HELP)
        self.assertEqual(list(syntax.commands), ["list", "echo"])
        self.assertEqual(list(syntax.options), ["--help", "--domain", "--no-fun"])
        self.assertEqual([syntax.options[o].takes_value for o in syntax.options],
                         [False, True, False])
        command = syntax_of_help(COMMAND_HELP)
        self.assertEqual([o.name for o in command.operands], ["topic"])
        self.assertEqual(command.options["--format"].choices, ("yaml", "json"))

    def test_topics_are_those_of_the_running_system_where_it_answers_in_time(self):
        begin = time.monotonic()
        self.assertIn("scarab/robot_state", self.texts("topic", "echo", ""))  # of the project: nobody answers
        self.assertLess(time.monotonic() - begin, 2.0)
        (self.room / "topics").write_text("rt/joint_states\n")
        self.assertEqual(self.texts("topic", "echo", ""), ["rt/joint_states"])
        (self.room / "seen").write_text(json.dumps([{"topic": "rt/joint_states", "type": "sensor::JointState_"}]))
        types = self.texts("topic", "echo", "a", "--type", "s")
        self.assertLessEqual({"sensor::JointState_", "scarab::Trial"}, set(types))

    def test_several_stacks_that_are_up_are_no_obstacle(self):
        stacks = self.room / "runs" / ".stacks"
        stacks.mkdir()
        for domain in (91, 92):
            RunningStack(Kind.LASTING, ProcessIdentity.of(os.getpid()), Bus(domain, "lo", ""),
                         RunDirectory(self.room / "runs" / "latest"), "plant=1", True, "plant=1",
                         Pace.LOCKSTEP).write(self.room / "runs")
        self.assertEqual(self.texts("topic", "li"), ["list"])
        (self.room / "topics").write_text("rt/joint_states\n")
        self.assertEqual(self.texts("topic", "--domain", "91", "echo", ""), ["rt/joint_states"])

    def test_log_is_completed_where_a_log_belongs_alone(self):
        (self.room / "runs" / "notes.txt").write_text("")
        runs = f"{self.room}/runs/"
        self.assertEqual(self.texts("log", "cat", runs), [f"{runs}2026-01-01-1/", f"{runs}latest/"])
        self.assertIn(f"{runs}notes.txt", self.texts("log", "cat", "--output", runs))

    def test_nothing_is_offered_of_a_log_that_cannot_be_read(self):
        self.assertEqual(self.texts("log", "cat", "none.mcap", "--topic", ""), [])
        self.assertEqual(self.texts("log", "cat", "--topic", ""), [])
        self.assertEqual(self.texts("log", "cat", "latest", "--field", ""), [])
        self.assertEqual(self.texts("log", "cat", "latest", "--topic", "no/such", "--field", ""), [])

    def test_short_option_with_a_value_is_no_operand(self):
        self.assertEqual(self.texts("log", "cat", "-n", "3", "lat"), ["latest"])
        self.assertEqual(self.texts("log", "cat", "-n", "lat"), [])

    def test_answer_comes_while_a_person_waits(self):
        """Measured by what an interpreter with the same libraries takes to start, on this machine now."""
        # The launcher compiled, as it is after its first start: tests leave nothing compiled behind otherwise.
        environment = {**os.environ, **self.environment, "PYTHONDONTWRITEBYTECODE": ""}

        def cost_s(command):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run(command, check=True, capture_output=True, env=environment)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

        start = ["/usr/bin/python3", "-c", "import argparse, json, subprocess, yaml"]
        ask = [str(SCARAB), ASK, "line", "scarab run --strategy "]
        ratios = [cost_s(ask) / max(0.01, cost_s(start)) for _ in range(5)]
        self.assertLess(min(ratios), 8.0, ratios)  # 2 to 4; 0.1 to 0.2 s where nothing else runs

    def test_tool_that_is_not_built_is_no_error_on_the_line(self):
        (self.room / "bin" / "scarab-topic").unlink()
        done = subprocess.run([str(SCARAB), ASK, "line", "scarab topic "], capture_output=True,
                              text=True, check=False, env={**os.environ, **self.environment})
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))


if __name__ == "__main__":
    unittest.main()
