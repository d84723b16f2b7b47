"""`scarab doctor`: looks for what would keep a stack from running, and says what to do about it."""

import argparse
import importlib
import os
import shutil
import subprocess
from typing import Callable, List, Optional, Tuple

from .failure import EXIT_FAILURE, EXIT_OK, Failure
from .places import Places, shown
from .preflight import check_configuration
from .running_stack import running_stacks
from .stack_file import read_stack

_LEAST_FREE_BYTES = 500 * 1000 * 1000
_TOOLS = ("scarab-experiment", "scarab-status", "scarab-topic", "scarab-log", "scarab-sim")
_INTERFACE_UP = 0x1

Finding = Optional[str]  # what is wrong and what to do; None: nothing
Check = Tuple[str, Callable[[], Finding]]


def doctor(options: argparse.Namespace, places: Places) -> int:
    """1 if anything was found."""
    checks: List[Check] = [
        ("packages", lambda: _packages(places)),
        ("programs", lambda: _programs(options, places)),
        ("configuration", lambda: _configuration(options, places)),
        ("interface", lambda: _interface(options, places)),
        ("matplotlib", _matplotlib),
        ("run directory", lambda: _runs(places)),
        ("environment", _environment),
        ("stacks", lambda: _stacks(places)),
    ]
    found = 0
    for name, check in checks:
        try:
            finding = check()
        except Failure as failure:
            finding = str(failure)
        found += finding is not None
        print(f"{name:15}{'ok' if finding is None else 'PROBLEM: ' + finding}")
    return EXIT_FAILURE if found else EXIT_OK


def _packages(places: Places) -> Finding:
    listing = subprocess.run(
        ["bash", "-c", '. "$1" && missing_packages build run', "bash",
         str(places.root / "deploy" / "setup.sh")],
        capture_output=True, text=True, check=False)
    missing = listing.stdout.split()
    if listing.returncode != 0:
        return f"the package list cannot be checked: {listing.stderr.strip()}"
    return f"missing: {' '.join(missing)}; run ./deploy/demo, or apt-get install them" if missing \
        else None


def _programs(options: argparse.Namespace, places: Places) -> Finding:
    stack = read_stack(places.stack_file, options.profile, places.root)
    names = [*(s.binary for s in stack.services), *_TOOLS]
    missing = [name for name in names if not os.access(places.bin / name, os.X_OK)]
    return f"not built in {shown(places.bin)}: {' '.join(missing)}; run ./deploy/demo" if missing \
        else None


def _configuration(options: argparse.Namespace, places: Places) -> Finding:
    check_configuration(places, read_stack(places.stack_file, options.profile, places.root))
    return None


def _interface(options: argparse.Namespace, places: Places) -> Finding:
    name = read_stack(places.stack_file, options.profile, places.root).interface
    try:
        with open(f"/sys/class/net/{name}/flags") as file:
            flags = int(file.read(), 16)
    except OSError:
        have = " ".join(sorted(os.listdir("/sys/class/net")))
        return f"there is no network interface '{name}' (there are: {have}); see bus.interface in " \
               f"{shown(places.stack_file)}"
    return None if flags & _INTERFACE_UP else f"interface '{name}' is down: ip link set {name} up"


def _matplotlib() -> Finding:
    try:
        importlib.import_module("matplotlib")
    except ImportError:
        return "missing, so no figure is drawn: apt-get install python3-matplotlib"
    return None


def _runs(places: Places) -> Finding:
    place = next(p for p in (places.runs, *places.runs.parents) if p.exists())
    if not os.access(place, os.W_OK):
        return f"{shown(place)} cannot be written to"
    free = shutil.disk_usage(place).free
    if free < _LEAST_FREE_BYTES:
        return f"only {free // 1000000} MB are free in {shown(place)}: remove old runs"
    return None


def _environment() -> Finding:
    if "CYCLONEDDS_URI" in os.environ:
        return "CYCLONEDDS_URI is set: the stack ignores it, your own DDS tools do not; unset it, " \
               "or see deploy/cyclonedds"
    return None


def _stacks(places: Places) -> Finding:
    halves = [s for s in running_stacks(places.runs) if not s.ready]
    return f"the stack on DDS domain {halves[0].bus.domain} is starting or stopping" if halves \
        else None
