"""Who is given which trial, and what happens where no answer comes."""

import contextlib
import io
import json
import os
import tempfile
import unittest
from pathlib import Path

from experiment_case import EXPERIMENT  # puts the launcher on the path, too
from launcher.experiments.dispatch import RETRIES, Dispatch
from launcher.experiments.experiment_file import read_experiment
from launcher.experiments.journal import Journal, read_journal
from launcher.experiments.plan import make_plan
from launcher.experiments.results import OUTCOME_KEYS
from launcher.experiments.seat import Fault
from launcher.failure import Failure, Interrupted
from launcher.signals import Signals


def answer_to(trial):
    outcome = {key: 0.0 for key in OUTCOME_KEYS}
    return json.dumps({**json.loads(trial.line()), **outcome, "success": True, "time_s": 12.5, "reason": "there"})


class FakeSeat:
    """Answers after `looks` looks; what it does instead is told by `orders`: index -> a list of strange answers."""

    def __init__(self, name, looks=1, orders=None):
        self.name = name
        self.given, self.cleared, self.asked = [], 0, 0
        self._looks, self._left = looks, 0
        self._orders = orders or {}
        self._trial = None
        self._always_readable, end = os.pipe()
        os.close(end)

    def give(self, trial):
        assert self._trial is None, "it has a trial"
        self._trial, self._left = trial, self._looks
        self.given.append(trial.index)

    def descriptors(self):
        return [self._always_readable]

    def look(self):
        if self._trial is None:
            return None
        self._left -= 1
        if self._left > 0:
            return None
        orders = self._orders.get(self._trial.index)
        if orders:
            order = orders.pop(0)
            if isinstance(order, Exception):
                raise order
            return order
        trial, self._trial = self._trial, None
        return answer_to(trial)

    def ask_to_end(self):
        self.asked += 1

    def clear(self):
        self._trial = None
        self.cleared += 1


class Dispatching(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.signals = Signals()

    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        experiment = Path(room.name) / "tiny.yaml"
        experiment.write_text(EXPERIMENT)
        self.trials = make_plan(read_experiment(experiment)).trials
        self.file = Path(room.name) / "journal.jsonl"
        self.heard = []
        self.now = 0.0
        self.signals.stop_requested = False

    def run_on(self, *seats, listen=None):
        journal = Journal(self.file)
        try:
            with contextlib.redirect_stderr(io.StringIO()):
                Dispatch(seats, self.trials, journal, listen or self.hear, self.signals, self.clock).run()
        finally:
            journal.close()
            self.assertTrue(all(seat.asked and seat.cleared for seat in seats))  # nothing is left running

    def hear(self, result):
        if result is not None:
            self.heard.append(result.trial.index)

    def clock(self):
        self.now += 1.0
        return self.now

    def done(self):
        return [result.trial.index for result in read_journal(self.file, self.trials)]

    def test_each_trial_goes_once_to_whoever_is_free(self):
        quick, slow = FakeSeat("quick"), FakeSeat("slow", looks=4)
        self.run_on(quick, slow)
        self.assertEqual(sorted(quick.given + slow.given), list(range(12)))
        self.assertGreater(len(quick.given), 2 * len(slow.given))
        self.assertEqual(self.done(), self.heard)
        self.assertEqual(sorted(self.heard), list(range(12)))

    def test_trial_without_an_answer_is_given_again_and_its_seat_cleared(self):
        for strange in (Fault("it has died"), '{"index": 3, "error": "plant is silent"}', "a line of the debugger",
                        answer_to(self.trials[4])):
            with self.subTest(strange=strange):
                self.heard = []
                self.file.unlink(missing_ok=True)
                seat = FakeSeat("seat", orders={3: [strange] * RETRIES})
                self.run_on(seat)
                self.assertEqual(seat.given.count(3), 1 + RETRIES)
                self.assertEqual(seat.cleared, RETRIES + 1)
                self.assertEqual(sorted(self.done()), list(range(12)))

    def test_after_the_last_attempt_it_ends_and_keeps_the_rest(self):
        seat = FakeSeat("seat", orders={3: [Fault(f"reason {n}") for n in range(RETRIES + 1)]})
        with self.assertRaisesRegex(Failure, "trial 3 could not be run in 3 attempts; .*on seat: reason 2"):
            self.run_on(seat)
        self.assertEqual(self.done(), [0, 1, 2])

    def test_worker_that_takes_no_trial_ends_it_at_once(self):
        seat = FakeSeat("seat", orders={1: ['{"error": "unknown key \'indx\'"}']})
        with self.assertRaisesRegex(Failure, "seat refuses its trials: unknown key"):
            self.run_on(seat)
        self.assertEqual(seat.given, [0, 1])

    def test_answer_that_never_comes_is_not_waited_for_for_ever(self):
        seat = FakeSeat("seat", looks=100000)
        with self.assertRaisesRegex(Failure, "there is no answer after 360 s"):
            self.run_on(seat)
        self.assertEqual(seat.given, [0] * (1 + RETRIES))

    def test_request_to_stop_ends_it_with_everything_kept(self):
        def listen(result):
            self.hear(result)
            self.signals.stop_requested = len(self.heard) >= 5

        with self.assertRaises(Interrupted):
            self.run_on(FakeSeat("one"), FakeSeat("two"), listen=listen)
        self.assertEqual(self.done(), self.heard)
        self.assertIn(len(self.heard), (5, 6))


if __name__ == "__main__":
    unittest.main()
