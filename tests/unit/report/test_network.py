"""Findings on the network, measured from its signals: they turn round when the signals do."""

import unittest

from made_up import trial
from made_up_log import INPUTS, neural_activity, write_log
from scratch_directory import ScratchDirectory

from report.neural import recording
from report.psn_row import switching


class Network(ScratchDirectory):
    def recorded(self, kind, change=lambda strategy, table: None, strategies=tuple(INPUTS)):
        """One log for each row of Table 1, each changed as the test wants it."""
        trials = [trial(i, strategy, 1, goal="none", height_m=0.0) for i, strategy in enumerate(strategies)]
        experiment = self.experiment(kind, trials)
        for asked in trials:
            table = neural_activity(asked["strategy"])
            change(asked["strategy"], table)
            write_log(self.room / kind / f"trial-{asked['index']}.mcap", asked, {"neural_activity": table})
        return experiment


class Cpg(Network):
    def test_period_and_amplitude_are_measured(self):
        found = {f.name: f for f in self.judged(self.recorded("cpg", strategies=["table-backward"]))}
        self.assertEqual([f.word for f in found.values()], ["agrees", "agrees"])
        self.assertRegex(found["cpg_periodic"].numbers[0], r"^period 14\.4\d ticks, 1\.44\d s at 10 Hz$")

    def test_an_orbit_that_repeats_is_not_quasi_periodic(self):
        def repeat(_, table):
            for name in ("cpg[0]", "cpg[1]"):
                table[name] = (table[name][:15] * 10)[:120]

        experiment = self.recorded("cpg", repeat, ["table-backward"])
        self.assertEqual(self.verdicts(experiment)["cpg_quasi_periodic"], "partly")

    def test_neurons_in_phase_are_not_an_oscillator(self):
        def in_phase(_, table):
            table["cpg[1]"] = table["cpg[0]"]

        self.assertEqual(self.verdicts(self.recorded("cpg", in_phase, ["table-backward"]))["cpg_periodic"], "partly")


class Psn(Network):
    def test_rows_pass_or_invert_as_in_the_paper(self):
        experiment = self.recorded("psn")
        self.assertEqual(self.verdicts(experiment), {"psn_rows": "agrees", "psn_amplitude": "agrees"})
        words = {strategy: switching(recording(experiment, strategy), "PSN1").word for strategy in INPUTS}
        self.assertEqual(words, {"table-forward": "pass", "table-backward": "pass", "table-soft-push": "invert",
                                 "table-boxing": "invert", "table-hard-push": "invert"})

    def test_swapped_outputs_are_seen(self):
        def swap(strategy, table):
            if strategy == "table-hard-push":
                table["psn1[12]"], table["psn1[13]"] = table["psn1[13]"], table["psn1[12]"]

        finding = self.judged(self.recorded("psn", swap))[0]
        self.assertEqual(finding.word, "partly")
        self.assertEqual(finding.reason, "hard pushing should invert")

    def test_a_signal_without_its_form_neither_passes_nor_is_inverted(self):
        def flatten(_, table):
            table["psn1[12]"] = [float(i % 3) for i in range(120)]

        experiment = self.recorded("psn", flatten)
        self.assertEqual(switching(recording(experiment, "table-forward"), "PSN1").word, "neither")
        self.assertEqual(self.verdicts(experiment)["psn_rows"], "does not agree")

    def test_amplitude_above_one_half_is_seen(self):
        def amplify(_, table):
            table["psn4[12]"] = [3 * value for value in table["psn4[12]"]]

        self.assertEqual(self.verdicts(self.recorded("psn", amplify))["psn_amplitude"], "partly")


class Vrn(Network):
    def test_amplitudes_and_synapses_as_in_the_paper(self):
        self.assertEqual(self.verdicts(self.recorded("vrn")), {"vrn_order": "agrees", "vrn_synapses": "agrees"})

    def test_another_order_is_seen(self):
        def louder(strategy, table):
            if strategy == "table-soft-push":
                table["vrn1[6]"] = [8 * value for value in table["vrn1[6]"]]

        self.assertEqual(self.verdicts(self.recorded("vrn", louder))["vrn_order"], "partly")

    def test_another_weight_is_seen(self):
        def weaker(_, table):
            table["vrn1[1]"] = [0.5 * value for value in table["vrn1[1]"]]

        self.assertEqual(self.verdicts(self.recorded("vrn", weaker))["vrn_synapses"], "does not agree")

    def test_missing_rows_and_logs_are_said(self):
        self.assertEqual(self.verdicts(self.recorded("vrn", strategies=["table-forward"]))["vrn_order"], "not measured")
        (self.room / "vrn" / "trial-0.mcap").unlink()
        finding = self.judged(self.recorded_again())[0]
        self.assertEqual(finding.word, "not measured")
        self.assertIn("has no log of table-forward", finding.reason)

    def recorded_again(self):
        return self.experiment("vrn", [trial(0, "table-forward", 1, goal="none", height_m=0.0)])


if __name__ == "__main__":
    unittest.main()
