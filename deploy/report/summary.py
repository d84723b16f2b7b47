"""summary.json: the report for programs."""

import json
from pathlib import Path
from typing import List

from .experiment import Experiment
from .findings.finding import Finding
from .wording import perturbation


def write_summary(file: Path, experiment: Experiment, findings: List[Finding]) -> None:
    plan = experiment.plan
    document = {
        "name": plan.name, "title": plan.title, "paper_figure": plan.paper_figure, "command": plan.command,
        "version": plan.version, "configuration": plan.configuration, "planned": len(plan.trials),
        "trials": len(experiment.trials), "complete": experiment.is_complete,
        "perturbation": perturbation(plan.trials), "seeds": sorted({trial.seed for trial in plan.trials}),
        "findings": [finding.document() for finding in findings],
        "cells": [cell.document() for cell in experiment.cells]}
    file.write_text(json.dumps(document, indent=2, ensure_ascii=False) + "\n")
