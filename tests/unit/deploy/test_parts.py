"""The launcher's smaller parts: back-off, run directories, domain claims, trial locks."""

import fcntl
import os
import tempfile
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import fake_stack  # noqa: F401  puts the launcher on the path
from launcher.back_off import LOOP_AFTER, BackOff
from launcher.domain_claim import DomainClaim, claim_domain
from launcher.failure import Failure
from launcher.restart_rule import must_wait, restart_allowed
from launcher.run_directory import create_run_directory, run_directories
from launcher.stack import BackOffTimes, Restart
from launcher.trial_lock import TrialLock, series_that_runs


class BackOffTest(unittest.TestCase):
    def test_doubles_up_to_the_cap(self):
        back_off = BackOff(BackOffTimes(0.1, 0.5, 30))
        waits = [back_off.crashed(0.0) for _ in range(5)]
        self.assertEqual(waits, [0.1, 0.2, 0.4, 0.5, 0.5])
        self.assertEqual(back_off.restarts, 5)

    def test_starts_over_after_a_long_good_run(self):
        back_off = BackOff(BackOffTimes(0.1, 5, 30))
        self.assertEqual([back_off.crashed(t) for t in (0, 0, 30)], [0.1, 0.2, 0.1])
        self.assertEqual((back_off.restarts, back_off.in_a_row), (3, 1))

    def test_counts_crashes_in_a_row_and_forgets_them(self):
        back_off = BackOff(BackOffTimes(0.1, 5, 30))
        self.assertFalse(back_off.runs_well(100))  # there is nothing to forget
        for _ in range(LOOP_AFTER):
            self.assertFalse(back_off.looping)
            back_off.crashed(1.0)
        self.assertTrue(back_off.looping)
        self.assertFalse(back_off.runs_well(29))
        self.assertEqual(back_off.time_to_forget(29), 1)
        self.assertTrue(back_off.runs_well(30))
        self.assertFalse(back_off.looping)
        self.assertEqual(back_off.restarts, LOOP_AFTER)

    def test_days_of_crashes_are_no_trouble(self):
        back_off = BackOff(BackOffTimes(0.1, 5, 30))
        self.assertEqual([back_off.crashed(0) for _ in range(5000)][-1], 5)


class RunDirectoryTest(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.runs = Path(room.name) / "runs"

    def test_many_at_once_get_directories_of_their_own(self):
        with ThreadPoolExecutor(8) as pool:
            made = list(pool.map(lambda _: create_run_directory(self.runs).path, range(24)))
        self.assertEqual(len(set(made)), 24)
        numbers = sorted(int(path.name.rsplit("-", 1)[1]) for path in made)
        self.assertEqual(numbers, list(range(1, 25)))

    def test_latest_points_to_the_newest_and_ten_follows_nine(self):
        for _ in range(11):
            newest = create_run_directory(self.runs)
        self.assertTrue(newest.path.name.endswith("-11"))
        self.assertEqual((self.runs / "latest").resolve(), newest.path.resolve())
        self.assertEqual(run_directories(self.runs)[-1], newest.path)

    def test_place_that_cannot_be_written_is_a_failure_in_words(self):
        file = self.runs.parent / "file"
        file.write_text("")
        with self.assertRaisesRegex(Failure, "cannot make a run directory"):
            create_run_directory(file)


class DomainClaimTest(unittest.TestCase):
    def test_a_domain_is_claimed_once_and_free_again_after_its_release(self):
        first = DomainClaim(221)
        with self.assertRaisesRegex(Failure, "DDS domain 221 is in use"):
            DomainClaim(221)
        first.release()
        DomainClaim(221).release()

    def test_without_a_wish_two_stacks_get_two_domains(self):
        first, second = claim_domain(None), claim_domain(None)
        self.assertNotEqual(first.domain, second.domain)
        first.release()
        second.release()


class RestartRule(unittest.TestCase):
    def test_plant_waits_for_the_end_of_the_trials_it_ended_in(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "trial.lock"
            self.assertEqual(series_that_runs(file), "")
            lock = TrialLock.try_take(file)
            first = series_that_runs(file)
            self.assertNotEqual(first, "")
            self.assertTrue(must_wait(Restart.BETWEEN_TRIALS, file, first))
            self.assertFalse(must_wait(Restart.ALWAYS, file, first))
            lock.release()
            self.assertEqual(series_that_runs(file), "")
            self.assertFalse(must_wait(Restart.BETWEEN_TRIALS, file, first))

    def test_plant_does_not_wait_for_trials_that_wait_for_it(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "trial.lock"
            TrialLock.try_take(file).release()
            self.assertFalse(must_wait(Restart.BETWEEN_TRIALS, file, ""))  # it ended between two
            first = TrialLock.try_take(file)
            ended_in = series_that_runs(file)
            first.release()
            second = TrialLock.try_take(file)
            self.assertNotEqual(series_that_runs(file), ended_in)
            self.assertFalse(must_wait(Restart.BETWEEN_TRIALS, file, ended_in))
            self.assertFalse(must_wait(Restart.BETWEEN_TRIALS, file, ""))
            second.release()

    def test_only_one_series_runs_and_a_look_turns_nobody_away(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "trial.lock"
            lock = TrialLock.try_take(file)
            self.assertIsNone(TrialLock.try_take(file))
            lock.release()
            with open(file) as looking:
                fcntl.flock(looking, fcntl.LOCK_SH)
                threading.Timer(0.05, lambda: fcntl.flock(looking, fcntl.LOCK_UN)).start()
                lock = TrialLock.try_take(file)
            self.assertIsNotNone(lock)
            lock.release()

    def test_bad_configuration_is_not_tried_again(self):
        self.assertFalse(restart_allowed(Restart.ALWAYS, 2))
        self.assertFalse(restart_allowed(Restart.NEVER, -9))
        self.assertTrue(restart_allowed(Restart.ALWAYS, -9))
        self.assertTrue(restart_allowed(Restart.BETWEEN_TRIALS, os.EX_OK))


if __name__ == "__main__":
    unittest.main()
