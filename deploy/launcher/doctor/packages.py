"""Debian packages of deploy/packages.txt that are not installed."""

import importlib
import subprocess
from typing import List

from .finding import Finding, ok, problem
from .subject import Subject


def packages(subject: Subject) -> List[Finding]:
    setup = subject.places.root / "deploy" / "setup.sh"
    asked = subprocess.run(
        ["bash", "-c", '. "$1" && packages_of build run | wc -l && missing_packages build run',
         "bash", str(setup)], capture_output=True, text=True, check=False)
    if asked.returncode != 0:
        return [problem(f"the package list cannot be checked: {asked.stderr.strip()}",
                        "See deploy/packages.txt and deploy/setup.sh.")]
    count, *missing = asked.stdout.split()
    if missing:
        return [problem(f"not installed: {', '.join(missing)}",
                        "Run ./deploy/demo, which installs what is missing; or as root: "
                        f"apt-get install --no-install-recommends {' '.join(missing)}")]
    return [ok(f"all {count} of deploy/packages.txt are installed")]


def figures(_: Subject) -> List[Finding]:
    try:
        importlib.import_module("matplotlib")
    except ImportError:
        return [problem("Python finds no matplotlib, so no figure is drawn",
                        "As root: apt-get install python3-matplotlib")]
    return [ok("can be drawn")]
