"""Intervals and exact tests against values known from elsewhere, and against what they mean."""

import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "deploy"))

from report.exact_tests import rank_sum_p, sign_p  # noqa: E402
from report.intervals import deviation, mean, median, wilson  # noqa: E402
from report.oscillation import amplitude, correlation, delayed_correlation, line_through, orbit  # noqa: E402


class Intervals(unittest.TestCase):
    def test_wilson_has_the_values_of_the_literature(self):
        # R: prop.test(x, n, correct = FALSE); Newcombe 1998, table I, for 81/263 and 15/148.
        for successes, n, low, high in ((81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611),
                                        (1, 29, 0.0061, 0.1718), (10, 10, 0.7225, 1.0), (9, 10, 0.5958, 0.9821)):
            with self.subTest(successes=successes, n=n):
                found = wilson(successes, n)
                self.assertAlmostEqual(found[0], low, places=4)
                self.assertAlmostEqual(found[1], high, places=4)

    def test_ends_of_wilson_solve_its_equation(self):
        z = 1.959963984540054
        for successes in range(1, 40):
            for end in wilson(successes, 40):
                if 0 < end < 1:
                    self.assertAlmostEqual(abs(successes / 40 - end), z * math.sqrt(end * (1 - end) / 40), places=12)

    def test_wilson_narrows_with_more_trials_and_knows_nothing_of_none(self):
        widths = [high - low for low, high in (wilson(n // 2, n) for n in (2, 10, 40, 400))]
        self.assertEqual(widths, sorted(widths, reverse=True))
        self.assertEqual(wilson(0, 0), (0.0, 1.0))

    def test_no_time_has_no_mean_and_one_has_no_deviation(self):
        self.assertIsNone(mean([]))
        self.assertIsNone(median([]))
        self.assertIsNone(deviation([3.0]))
        self.assertAlmostEqual(deviation([2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]), math.sqrt(32 / 7))


class ExactTests(unittest.TestCase):
    def test_rank_sum_of_separate_samples_is_one_way_of_all(self):
        self.assertAlmostEqual(rank_sum_p([1, 2, 3], [4, 5, 6]), 1 / math.comb(6, 3))
        self.assertAlmostEqual(rank_sum_p([4, 5, 6], [1, 2, 3]), 1.0)

    def test_rank_sum_has_a_value_of_the_literature(self):
        # R: wilcox.test(c(0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46),
        #                c(1.15, 0.88, 0.90, 0.74, 1.21), alternative = "g"), Hollander & Wolfe 1973: p = 0.1272
        x = [0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46]
        y = [1.15, 0.88, 0.90, 0.74, 1.21]
        self.assertAlmostEqual(rank_sum_p(y, x), 0.1272, places=4)

    def test_ties_share_their_ranks(self):
        self.assertEqual(rank_sum_p([5.0] * 4, [5.0] * 4), 1.0)
        self.assertAlmostEqual(rank_sum_p([1, 2], [2, 3]), 1 / 3)  # ranks 1, 2.5, 2.5, 4: two of six sums are 3.5

    def test_sign_test_is_a_tail_of_coin_tosses(self):
        self.assertAlmostEqual(sign_p(10, 0), 1 / 1024)
        self.assertAlmostEqual(sign_p(5, 5), 0.623046875)
        self.assertEqual(sign_p(0, 0), 1.0)


class Oscillations(unittest.TestCase):
    def test_orbit_knows_the_period_of_a_turning_point(self):
        period = 14.43
        angles = [-2 * math.pi * i / period for i in range(300)]
        found = orbit([math.cos(a) for a in angles], [0.8 * math.sin(a) for a in angles])
        self.assertAlmostEqual(found.period_ticks, period, delta=0.003)
        self.assertTrue(found.clockwise)
        self.assertLess(found.scatter, 0.005)
        self.assertFalse(found.repeats)

    def test_orbit_that_repeats_or_drifts_is_found_out(self):
        angles = [2 * math.pi * i / 15 for i in range(150)]
        self.assertTrue(orbit([math.cos(a) for a in angles], [math.sin(a) for a in angles]).repeats)
        drift = [(1 + 0.002 * i) for i in range(150)]
        angles = [2 * math.pi * i / 14.43 for i in range(150)]
        found = orbit([r * math.cos(a) for r, a in zip(drift, angles)],
                      [r * math.sin(a) for r, a in zip(drift, angles)])
        self.assertGreater(found.scatter, 0.02)

    def test_correlation_knows_delay_and_sign(self):
        source = [math.sin(0.43 * i) for i in range(100)]
        late = [0.0] * 4 + [-0.4 * value + 0.1 for value in source[:-4]]
        self.assertAlmostEqual(delayed_correlation(late, source, 4), -1.0)
        self.assertGreater(abs(delayed_correlation(late, source, 0)), 0.1)
        self.assertLess(abs(delayed_correlation(late, source, 0)), 0.9)
        self.assertEqual(correlation([1.0, 1.0], [1.0, 2.0]), 0.0)
        self.assertAlmostEqual(amplitude([0.1, -0.3, 0.5]), 0.4)

    def test_line_is_found_again(self):
        x = [0.1 * i * i for i in range(20)]
        slope, start = line_through(x, [2 * value + 0.02 for value in x])
        self.assertAlmostEqual(slope, 2)
        self.assertAlmostEqual(start, 0.02)


if __name__ == "__main__":
    unittest.main()
