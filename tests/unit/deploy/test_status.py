"""`scarab status`: what is said of a stack, for people and for programs."""

import io
import json
import os
import pty
import re
import signal
import subprocess
import unittest

from fake_stack import SCARAB, FakeStackTest, wait_until
from launcher.status.screen import Screen, clipped
from launcher.status.table import duration, time_text
from launcher.status.waits import waits

# Stands in for scarab-status: everybody is ready; what its file `said` holds, with --watch every 0.05 s.
SAYS = """#!/usr/bin/python3
import sys, time
from pathlib import Path
if "--json" not in sys.argv:
    sys.exit(0)
while True:
    print(Path(__file__).with_name("said").read_text().strip(), flush=True)
    if "--watch" not in sys.argv:
        break
    time.sleep(0.05)
"""
EXPECTED = ("logger", "plant", "supervisor", "premotor")


def report(name, health="ok", message="", tick=412, instance=0, **more):
    return {"service": name, "instance": instance, "lifecycle": "active", "health": health,
            "message": message, "trial": 3, "tick": tick, "sim_time_s": tick / 10, "stamp_ns": 1,
            "ticks_per_s": 10.0, "real_time_factor": 1.0, "ready_trial": 3, "recorded_trial": 0,
            "recorded_tick": 0, "pid": 4711, "host": "beetle", "counters": {}, "histograms": {}, **more}


class Waits(unittest.TestCase):
    def sentences(self, *services):
        return waits(services, EXPECTED)

    def test_nobody_waits(self):
        self.assertEqual(self.sentences(report("plant"), report("premotor")), [])

    def test_chain_is_one_sentence_to_its_end(self):
        self.assertEqual(
            self.sentences(report("plant", "waiting", "supervisor has not answered tick 4"),
                           report("supervisor", "waiting", "waits for premotor/0 to read scarab/behaviour")),
            ["plant/0 waits for supervisor/0, which waits for premotor/0, which says nothing"])

    def test_fault_at_the_end_of_the_chain_is_told(self):
        self.assertEqual(
            self.sentences(report("plant", "waiting", "waits for premotor/0 to be ready"),
                           report("premotor", "fault", "cannot answer tick 4")),
            ["plant/0 waits for premotor/0, which has a fault: cannot answer tick 4"])

    def test_several_at_once(self):
        self.assertEqual(
            self.sentences(report("plant", "waiting", "waits for premotor/0 to write "
                                  "scarab/joint_command, premotor/1 to be ready and logger/0 to be ready"),
                           report("logger")),
            ["plant/0 waits for premotor/0, premotor/1 and logger/0, premotor/0 says nothing, "
             "premotor/1 says nothing"])

    def test_two_that_wait_for_each_other(self):
        self.assertEqual(
            self.sentences(report("plant", "waiting", "waits for logger/0 to be ready"),
                           report("logger", "waiting", "waits for plant/0 to write scarab/trial")),
            ["plant/0 waits for logger/0, which waits for plant/0"])

    def test_who_waits_for_nobody_by_name_is_quoted(self):
        self.assertEqual(self.sentences(report("plant", "waiting", "paused by the operator")),
                         ["plant/0: paused by the operator"])

    def test_topics_are_no_services(self):
        self.assertEqual(
            waits([report("plant", "waiting", "waits for premotor/0 to read scarab/trial")],
                  (*EXPECTED, "trial", "scarab")),
            ["plant/0 waits for premotor/0, which says nothing"])


class Texts(unittest.TestCase):
    def test_durations(self):
        self.assertEqual([duration(s) for s in (0, 59.9, 61, 3600, 90061)],
                         ["0:00", "0:59", "1:01", "1:00:00", "1 d 1:01:01"])

    def test_times(self):
        self.assertEqual([time_text(s) for s in (0, 2e-5, 1.5e-3, 0.05, 2)],
                         ["0 us", "20 us", "1.5 ms", "50 ms", "2 s"])

    def test_clipping_counts_what_shows_and_ends_colours(self):
        self.assertEqual(clipped("abcdef", 3), "abc")
        self.assertEqual(clipped("a\033[31mbcd\033[0me", 2), "a\033[31mb\033[0m")

    def test_screen_into_a_file_is_plain_blocks(self):
        out = io.StringIO()
        with Screen(out) as screen:
            screen.draw(["one", "two"])
            screen.draw(["three"])
        self.assertEqual(out.getvalue(), "one\ntwo\n\nthree\n\n")


class Status(FakeStackTest):
    domain = 0

    def setUp(self):
        super().setUp()
        Status.domain += 1
        self.words = ("--domain", str(200 + Status.domain))
        (self.bin / "scarab-status").write_text(SAYS)
        self.say(*self.all_well())
        code, out, err = self.scarab("up", *self.words)
        self.assertEqual(code, 0, out + err)

    def say(self, *services):
        new = self.bin / "said.new"
        new.write_text(json.dumps({"tick_master": "plant/0", "services": services}) + "\n")
        os.replace(new, self.bin / "said")

    def all_well(self):
        return report("logger"), report("plant"), report("premotor")

    def json(self):
        code, out, _ = self.scarab("status", "--json", *self.words)
        document = json.loads(out)
        self.assertEqual(document["healthy"], code == 0)
        self.assertEqual(document["healthy"], not document["troubles"])
        return document

    def trouble(self):
        """The one thing that is wrong."""
        (text,) = self.json()["troubles"]
        return text

    def test_stack_that_is_well(self):
        document = self.json()
        self.assertTrue(document["healthy"])
        (stack,) = document["stacks"]
        self.assertEqual((stack["tick_master"], stack["trial"], stack["tick"], stack["ticks_per_s"],
                          stack["real_time_factor"]), ("plant/0", 3, 412, 10.0, 1.0))
        self.assertEqual([p["name"] for p in stack["processes"]],
                         ["keeper", "logger", "plant", "premotor"])
        for process in stack["processes"]:
            self.assertTrue(process["running"])
            self.assertGreater(process["memory_bytes"], 1000000)
            self.assertGreaterEqual(process["uptime_s"], 0.0)
            os.kill(process["pid"], 0)

    def test_keys_are_those_of_the_documentation(self):
        readme = (SCARAB.parents[1] / "tools" / "status" / "README.md").read_text()
        (stack,) = self.json()["stacks"]
        for key in (*self.json(), *stack, *stack["processes"][0]):
            self.assertIn(f"`{key}`", readme)

    def test_table(self):
        self.say(report("logger"), report("plant", counters={"targets_clamped_window": 17}, histograms={
            "tick_jitter": {"count": 9, "p50_s": 5e-5, "p99_s": 1e-3, "max_s": 2e-3, "mean_s": 1e-4}}),
                 report("premotor"))
        code, out, _ = self.scarab("status", *self.words)
        self.assertEqual(code, 0, out)
        self.assertIn("trial 3: tick 412, 41.2 s, 10.0 ticks/s, 1.00 x real time\n", out)
        self.assertRegex(out, r"plant +\d+ +0:0\d +0 +\d+ % +\d+ MB +active +ok +3 +412 +10\.0\n")
        self.assertIn("refused: plant/0: targets_clamped_window 17\n", out)
        self.assertRegex(out, r"plant/0 tick_jitter +50 us +1 ms +2 ms +9\n")
        self.assertNotIn("\033", out)

    def test_unwell_service_is_quoted(self):
        self.say(report("logger"), report("plant", "degraded", "safe stop: stale"), report("premotor"))
        self.assertEqual(self.trouble(), "plant/0 is degraded: safe stop: stale")

    def test_robot_that_is_not_there_is_waited_for(self):
        self.say(report("logger"), report("plant", "waiting", "no device at /dev/ttyUSB0", trial=0,
                                          lifecycle="unconfigured"), report("premotor"))
        self.assertEqual(self.trouble(), "plant/0: no device at /dev/ttyUSB0")
        out = self.scarab("status", *self.words)[1]
        self.assertRegex(out, r"plant .* unconfigured +waiting ")
        self.assertIn("waiting: plant/0: no device at /dev/ttyUSB0\n", out)

    def test_trial_whose_robot_is_lost_is_not_over(self):
        self.say(report("logger"), report("plant", "degraded", "safe stop: lost", lifecycle="inactive"),
                 report("premotor"))
        self.assertIn("trial 3: tick 412, 41.2 s, 10.0 ticks/s", self.scarab("status", *self.words)[1])
        self.say(report("logger"), report("plant", lifecycle="inactive"), report("premotor"))
        self.assertIn("trial 3: tick 412, 41.2 s, over\n", self.scarab("status", *self.words)[1])

    def test_pause_is_shown_but_is_no_trouble(self):
        self.say(report("logger"), report("plant", "waiting", "paused by the operator"),
                 report("premotor"))
        document = self.json()
        self.assertTrue(document["healthy"])
        self.assertEqual(document["stacks"][0]["waits"], ["plant/0: paused by the operator"])

    def test_wait_is_a_trouble(self):
        self.say(report("logger"), report("plant", "waiting", "premotor has not answered tick 2"),
                 report("premotor"))
        self.assertEqual(self.trouble(), "plant/0 waits for premotor/0")

    def test_process_that_says_nothing(self):
        self.say(report("logger"), report("plant"))
        self.assertIn(f"premotor/0 says nothing on DDS domain {self.words[1]}", self.trouble())
        self.assertRegex(self.scarab("status", *self.words)[1], r"premotor .* silent ")

    def test_service_of_another_host_has_a_line(self):
        self.say(*self.all_well(), report("camera", instance=1, pid=99))
        (stack,) = self.json()["stacks"]
        self.assertEqual([(s["name"], s["host"], s["pid"]) for s in stack["elsewhere"]],
                         [("camera/1", "beetle", 99)])
        self.assertRegex(self.scarab("status", *self.words)[1], r"camera/1 on beetle +99 ")

    def test_crashed_process_and_its_restarts(self):
        self.order("scarab-premotor", "crash")
        wait_until(lambda: self.journal().count(("start", "scarab-premotor")) == 2, "it is restarted")
        premotor = self.json()["stacks"][0]["processes"][-1]
        self.assertEqual((premotor["name"], premotor["restarts"]), ("premotor", 1))

    def test_watch_as_lines_of_json_until_interrupted(self):
        watching = self.start("status", "--watch", "--json", "--period", "0.2", *self.words)
        first = json.loads(watching.stdout.readline())
        self.assertEqual(first["stacks"][0]["tick"], 412)
        self.say(report("logger"), report("plant", tick=500), report("premotor"))
        wait_until(lambda: json.loads(watching.stdout.readline())["stacks"][0]["tick"] == 500, "news")
        watching.send_signal(signal.SIGINT)
        code, _, err = self.finish(watching)
        self.assertEqual((code, err), (0, ""))

    def test_watch_goes_on_when_the_stack_goes(self):
        watching = self.start("status", "--watch", "--json", "--period", "0.2", *self.words)
        json.loads(watching.stdout.readline())
        self.assertEqual(self.scarab("down", *self.words)[0], 0)
        gone = f"no stack is running on DDS domain {self.words[1]}"
        wait_until(lambda: json.loads(watching.stdout.readline())["troubles"] == [gone], "it is gone")
        watching.send_signal(signal.SIGINT)
        self.assertEqual(self.finish(watching)[0], 0)

    def on_a_terminal(self, environment, *words):
        """What a terminal of 30 lines gets of `status WORDS` until it shows `trial 3` twice or ends."""
        master, slave = pty.openpty()
        launcher = subprocess.Popen(
            [str(SCARAB), "status", "--stack", str(self.stack_file), "--bin", str(self.bin), "--runs",
             str(self.runs), *self.words, *words], stdout=slave, stdin=slave, start_new_session=True,
            env={**os.environ, "TERM": "xterm", "LINES": "30", "COLUMNS": "100", **environment})
        os.close(slave)
        shown = b""
        try:
            while shown.count(b"trial 3") < 2:
                shown += os.read(master, 4096)
        except OSError:  # it has ended
            pass
        launcher.send_signal(signal.SIGINT)
        try:
            while True:
                shown += os.read(master, 4096)
        except OSError:
            pass
        os.close(master)
        return launcher.wait(), shown.decode()

    def test_colours_on_a_terminal_but_not_with_no_color(self):
        self.assertIn("\033[32mok", self.on_a_terminal({"NO_COLOR": ""})[1])
        self.assertNotIn("\033", self.on_a_terminal({"NO_COLOR": "1"})[1])

    def test_watch_draws_over_itself_and_leaves_the_terminal_as_it_was(self):
        code, shown = self.on_a_terminal({}, "--watch", "--period", "0.2")
        self.assertEqual(code, 0)
        self.assertTrue(shown.startswith("\033[?25l"))
        self.assertTrue(shown.endswith("\033[?25h"))
        first, second = shown.split("trial 3")[:2]
        self.assertNotIn("\033[2J", shown)  # the whole screen is never cleared: that flickers
        up = re.search(r"\033\[(\d+)F", second)
        self.assertEqual(int(up[1]), (first + second).split(up[0])[0].count("\n"))


class NothingRuns(FakeStackTest):
    def test_it_says_so(self):
        self.assertEqual(self.scarab("status")[:2], (1, "no stack is running\n"))
        code, out, _ = self.scarab("status", "--json")
        self.assertEqual((code, json.loads(out)), (1, {
            "healthy": False, "troubles": ["no stack is running"], "stacks": []}))

    def test_bad_usage(self):
        for words in (["--period", "0"], ["--period", "soon"], ["more"]):
            self.assertEqual(self.scarab("status", *words)[0], 2)


if __name__ == "__main__":
    unittest.main()
