"""What config/experiments/NAME.yaml may hold. Editors that know its schema (`scarab config schema
experiment`) show the notes."""

import json
from typing import Dict

from ..declaration import Boolean, Choice, Fields, Integer, ListOf, Number, Part, Text, described

FIGURES = ("cpg", "psn", "vrn", "transport_speed", "obstacle", "sequence", "walking", "beyond",
           "robustness")
GOALS = ("travel", "across", "walk", "none")
MOST_SEED = 2**64 - 1

# What a trial is, but for its seed and its perturbation; in the order of the plan's columns.
SCENE: Dict[str, Part] = {
    "strategy": Text("of the supervisor's configuration"),
    "goal": Choice(GOALS, "object moved, object across the obstacle, robot moved, or none: until the time "
                          "limit"),
    "height_m": Number(0.0, 0.5, "of the obstacle; 0: none"),
    "distance_m": Number(0.01, 10.0, "for the goals travel (of the object) and walk (of the robot)"),
    "time_limit_s": Number(0.1, 36000.0, "simulated time until the trial has failed"),
    "friction_scale": Number(0.01, 10.0, "of every friction coefficient (1)"),
    "object_mass_kg": Number(0.0, 100.0, "0 (as without the key): as in the plant's configuration"),
    "object_diameter_m": Number(0.0, 1.0, "0 (as without the key): as in the plant's configuration"),
}
DEFAULTS = {"friction_scale": 1.0, "object_mass_kg": 0.0, "object_diameter_m": 0.0}

EXPERIMENT = Fields(
    required={
        "title": Text("of the report"),
        "figure": Choice(FIGURES, "what is drawn of the results"),
        "paper": ListOf(Text(), "what the paper says of it, in words: a paragraph each", least=1),
        "grids": ListOf(
            Fields({}, {name: ListOf(part, part.note, least=1) for name, part in SCENE.items()}),
            "each stands for every combination of its lists, the last one varying fastest; together they are "
            "the cells",
            least=1),
        "every_trial": Fields({}, SCENE, "what no grid varies"),
        "trials": Integer(1, 100000, "in each cell"),
        "first_seed": Integer(0, MOST_SEED, "of each cell's first trial; the next ones count on"),
        "perturbation": Fields({
            "position_m": Number(0.0, 0.2, "start position: uniform in +- this, x and y"),
            "yaw_rad": Number(0.0, 3.1415926535897932, "start heading: uniform in +- this"),
            "friction": Number(0.0, 0.9, "every coefficient has a factor of its own, uniform in 1 +- this"),
            "cpg_phase": Boolean("start phase of the CPG: uniform over the circle"),
        }, note="of each trial, by its seed"),
    },
    optional={
        "paper_figure": Text("such as Fig. 5; without it the paper has none"),
        "notes": ListOf(Text(), "what limits a finding: a paragraph each"),
        "record": Boolean("every trial is recorded, and figures are drawn from the logs (false)"),
    })


def experiment_schema() -> str:
    """The JSON Schema of an experiment's file."""
    return json.dumps({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "$comment": "Written by scarab config schema experiment; do not edit.",
        "title": "Scarab: config/experiments",
        **described(EXPERIMENT)}, indent=2) + "\n"
