"""What is wrong with the machine and the installation: packages, programs, files, disk, rights."""

import os
import resource
import shutil
import subprocess

import case
from case import SOURCE_ROOT, DoctorCase, sh


def processor_s():
    """What the programs run by this process have used."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Machine(DoctorCase):
    def test_machine_that_is_well_is_told_so_at_once(self):
        begin = processor_s()
        found = self.doctor("--domain", "4")
        self.assertLess(processor_s() - begin, 1.5)  # whatever else keeps the machine busy
        self.assertEqual([f for f in found if f[1] == "problem"], [])

    def test_table_for_people(self):
        done = self.scarab("doctor", "network", "environment")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stdout,
                         "ok      environment    nothing in it changes DDS\n"
                         "ok      network        'lo' is up, its address is 127.0.0.1\n"
                         "no problems\n")
        self.assertEqual(done.stderr, "")

    def test_bad_usage(self):
        for words, reason in ((["netwrk"], "did you mean 'network'?"),
                              (["--profile", "simm"], "did you mean 'sim'?")):
            done = self.scarab("doctor", *words)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(reason, done.stderr)

    def test_missing_package(self):
        copy = self.folder / "tree"
        for part in ("deploy", "config"):
            shutil.copytree(SOURCE_ROOT / part, copy / part)
        with open(copy / "deploy" / "packages.txt", "a") as packages:
            packages.write("\n[run]\nlibscarab-that-nobody-has\n")
        done = subprocess.run([copy / "deploy" / "scarab", "doctor", "packages"], capture_output=True,
                              text=True, timeout=case.PATIENCE_S, env=self.environment, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("PROBLEM packages       not installed: libscarab-that-nobody-has\n", done.stdout)
        self.assertIn("apt-get install --no-install-recommends libscarab-that-nobody-has", done.stdout)

    def test_programs_that_are_not_built(self):
        self.bin = self.folder
        what, advice = self.only("problem", "programs")
        self.assertRegex(what, "^not built in .+: scarab-logger, scarab-plant, ")
        self.assertIn("./deploy/demo", advice)
        self.assertIn("not all built", self.only("note", "configuration")[0])

    def test_configuration_that_a_service_refuses(self):
        config = self.folder / "premotor.yaml"
        config.write_text("nonsense: 1\n")
        text = self.stack_file.read_text()
        self.stack_file = self.folder / "stack.yaml"
        self.assertIn("config: config/premotor/{robot}.yaml", text)
        self.stack_file.write_text(text.replace("config: config/premotor/{robot}.yaml",
                                                f"config: {config}"))
        what, _ = self.only("problem", "configuration")
        self.assertRegex(what, rf"^{config}:\d+:\d+: ")

    def test_mistake_in_the_stack_file_leaves_the_other_checks_alone(self):
        self.stack_file = self.folder / "stack.yaml"
        self.stack_file.write_text("bus: [lo\n")
        found = self.doctor("configuration", "network", "ports", "--domain", "4")
        self.assertRegex(found[0][2], rf"^{self.stack_file}:\d+:\d+: .*not valid YAML")
        self.assertEqual([f[1] for f in found], ["problem", "ok", "ok"])

    def test_disk_that_is_nearly_full(self):
        self.runs.mkdir()
        sh(f"mount -t tmpfs -o size=1m none {self.runs}")
        self.addCleanup(sh, f"umount {self.runs}")
        what, advice = self.only("problem", "storage")
        self.assertRegex(what, f"^only 1.0 MB are free in {self.runs}: the logger writes nothing with less than "
                               r"\d+\.\d MB \(free_disk_mib")
        self.assertIn("Remove old runs", advice)

    def test_run_directory_that_cannot_be_written_to(self):
        self.runs.mkdir()
        sh(f"mount -t tmpfs -o ro none {self.runs}")
        self.addCleanup(sh, f"umount {self.runs}")
        what, advice = self.only("problem", "storage")
        self.assertEqual(what, f"{self.runs} cannot be written to, so that no run directory can be made")
        self.assertIn("--runs DIR", advice)

    def test_cyclonedds_uri(self):
        self.environment["CYCLONEDDS_URI"] = "file:///home/somebody/cyclonedds.xml"
        what, advice = self.only("problem", "environment")
        self.assertIn("CYCLONEDDS_URI is set (file:///home/somebody/cyclonedds.xml)", what)
        self.assertIn("Unset it", advice)

    def test_rights_for_real_time(self):
        user = os.environ.get("USER") or str(os.getuid())
        what, advice = self.only("note", "realtime", before=(
            "prlimit", "--memlock=65536:65536", "--rtprio=0:0",
            "setpriv", "--bounding-set=-ipc_lock,-sys_nice", "--inh-caps=-ipc_lock,-sys_nice"))
        self.assertEqual(what, "memory may not be locked (memlock is 64 kB) and no real-time priority of "
                               "20 may be taken: ticks in real time may come late on a busy machine")
        self.assertIn(f"'{user} - memlock unlimited' and '{user} - rtprio 20'", advice)


if __name__ == "__main__":
    case.main()
