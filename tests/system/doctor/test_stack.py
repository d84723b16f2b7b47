"""What can be wrong with a stack that runs, or ran: jumps of the clock, killed keepers, full disks."""

import json
import os
import signal
import subprocess
from pathlib import Path

import case
from case import BIN, DOMAIN, TEST_PROGRAMS, DoctorCase, wait_until


class Stack(DoctorCase):
    def recorded(self):
        return json.loads((self.runs / ".stacks" / f"domain-{DOMAIN}.json").read_text())

    def keeper(self):
        return self.recorded()["keeper"]["pid"]

    def run_directory(self):
        return Path(self.recorded()["directory"])

    def a_trial_runs(self):
        """Until the end of the test."""
        trial = subprocess.Popen(self.command("run", "--goal", "none", "--time-limit", "3600"),
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 env=self.environment)
        self.addCleanup(trial.wait, case.PATIENCE_S)
        self.addCleanup(trial.terminate)
        wait_until(lambda: self.tick_master()["tick"] > 0, "the trial runs")

    def tick_master(self):
        """What the plant says of itself; without a report yet, nothing has happened."""
        done = subprocess.run([BIN / "scarab-status", "--domain", str(DOMAIN), "--json"],
                              capture_output=True, text=True, timeout=case.PATIENCE_S, check=False)
        return next((s for s in json.loads(done.stdout)["services"] if s["service"] == "plant"),
                    {"tick": 0, "counters": {}})

    def test_clock_that_jumps(self):
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        for program in BIN.glob("scarab-*"):
            (self.bin / program.name).symlink_to(program)
        jump = self.folder / "jump"
        (self.bin / "scarab-plant").unlink()
        (self.bin / "scarab-plant").write_text(
            f"#!/bin/sh\nSCARAB_TEST_JUMP={jump} LD_PRELOAD={TEST_PROGRAMS / 'clock_jump.so'} "
            f'exec {BIN / "scarab-plant"} "$@"\n')
        (self.bin / "scarab-plant").chmod(0o755)
        self.up()
        self.a_trial_runs()
        self.assertEqual([f[1:3] for f in self.doctor("clock")], [("ok", "no jumps were seen")])
        jump.touch()
        wait_until(lambda: self.tick_master()["counters"].get("clock_jumps"), "the plant notices")
        what, advice = self.only("problem", "clock")
        self.assertTrue(what.startswith("the system clock jumped once while plant/0 ran"), what)
        self.assertIn("chrony", advice)

    def test_real_time_without_the_rights_for_it(self):
        self.up(before=("prlimit", "--memlock=65536:65536", "--rtprio=0:0",
                        "setpriv", "--bounding-set=-ipc_lock,-sys_nice", "--inh-caps=-ipc_lock,-sys_nice"))
        notes = [f[2] for f in self.doctor("realtime") if f[1] == "note"]
        self.assertIn("plant/0: its memory is not locked", notes)
        self.assertIn("plant/0: its priority is not raised", notes)

    def test_keeper_that_was_killed(self):
        self.up()
        keeper = self.keeper()
        os.kill(keeper, signal.SIGKILL)
        wait_until(lambda: not self.alive(keeper), "the keeper is dead")
        what, advice = self.only("problem", "leftovers")
        self.assertIn(f"the keeper (pid {keeper}) of the stack on DDS domain {DOMAIN} was killed and left "
                      f"{self.runs}/.stacks/domain-{DOMAIN}.json", what)
        self.assertEqual(advice,
                         f"deploy/scarab down --domain {DOMAIN} ends and clears away all of it.")
        self.assertEqual(self.scarab("down", "--domain", str(DOMAIN)).returncode, 0)
        self.assertEqual([f[1] for f in self.doctor("leftovers")], ["ok"])

    def test_services_that_outlive_their_keeper_are_named(self):
        self.up()
        keeper = self.keeper()
        logger = json.loads((self.run_directory() / "pids" / "logger.json").read_text())["pid"]
        os.kill(logger, signal.SIGSTOP)
        os.kill(keeper, signal.SIGKILL)
        wait_until(lambda: not self.alive(keeper), "the keeper is dead")
        self.assertIn(f"logger (pid {logger})", self.only("problem", "leftovers")[0])
        self.assertTrue(self.alive(logger), "the doctor only looks")
        os.kill(logger, signal.SIGCONT)
        wait_until(lambda: not self.alive(logger), "it has ended")

    def test_disk_that_a_lasting_stack_fills(self):
        self.up()
        free = os.statvfs(self.runs)
        started = self.run_directory() / "config"
        hour_ago = started.stat().st_mtime - 3600
        os.utime(started, (hour_ago, hour_ago))
        log = self.run_directory() / "trial-2.mcap"
        log.touch()
        os.truncate(log, free.f_bavail * free.f_frsize // 3)  # a sparse file: only its length counts
        what, advice = self.only("note", "storage")
        self.assertRegex(what, r"are free, and the log of .* grows by .*B an hour: its logger stops in "
                               r"\d\.\d h$")
        self.assertIn("deploy/scarab down", advice)
        os.truncate(log, free.f_bavail * free.f_frsize * 2)
        self.assertRegex(self.only("problem", "storage")[0], r"its logger stops in 0\.\d h$")

    @staticmethod
    def alive(pid):
        try:
            with open(f"/proc/{pid}/stat") as stat:
                return stat.read().rsplit(")", 1)[1].split()[0] not in "ZX"
        except OSError:
            return False


if __name__ == "__main__":
    case.main()
