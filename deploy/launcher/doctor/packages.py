"""Debian packages of deploy/packages.txt that are not installed."""

import importlib.util
import subprocess
from typing import List

from .finding import Finding, ok, problem
from .subject import Subject


def packages(subject: Subject) -> List[Finding]:
    setup = subject.places.root / "deploy" / "setup.sh"
    listed = subprocess.run(["bash", "-c", '. "$1" && packages_of build run', "bash", str(setup)],
                            capture_output=True, text=True, check=False)
    if listed.returncode != 0:
        return [problem(f"the package list cannot be read: {listed.stderr.strip()}",
                        "See deploy/packages.txt and deploy/setup.sh.")]
    wanted = listed.stdout.split()
    missing = _not_installed(wanted)
    if missing:
        return [problem(f"not installed: {', '.join(missing)}",
                        "Run ./deploy/demo, which installs what is missing; or as root: "
                        f"apt-get install --no-install-recommends {' '.join(missing)}")]
    return [ok(f"all {len(wanted)} of deploy/packages.txt are installed")]


def _not_installed(wanted: List[str]) -> List[str]:
    """As missing_packages of setup.sh, with one question for all."""
    answer = subprocess.run(
        ["dpkg-query", "-W", "-f", "${db:Status-Abbrev} ${Package}\n", *wanted],
        capture_output=True, text=True, check=False).stdout
    installed = {line.split()[-1] for line in answer.splitlines() if line[1:2] == "i"}
    return [name for name in wanted if name not in installed]


def figures(_: Subject) -> List[Finding]:
    if importlib.util.find_spec("matplotlib") is None:
        return [problem("Python finds no matplotlib, so no figure is drawn",
                        "As root: apt-get install python3-matplotlib")]
    return [ok("can be drawn")]
