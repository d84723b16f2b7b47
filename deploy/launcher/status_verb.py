"""`scarab status` and `scarab logs`: what runs, and what it says."""

import argparse
import os
import sys
from pathlib import Path
from typing import List

from .failure import EXIT_FAILURE, EXIT_OK, Failure, UsageError
from .foreground import run_in_front
from .places import Places, shown
from .process_identity import ProcessIdentity, read_json
from .run_directory import RunDirectory
from .running_stack import RunningStack, choose_stack, running_stacks
from .service_child import last_lines
from .signals import Signals
from .strict_yaml import did_you_mean


def status(options: argparse.Namespace, places: Places) -> int:
    """0 if a stack runs and all its processes live, else 1."""
    signals = Signals()
    stacks = [s for s in running_stacks(places.runs) if options.domain in (None, s.bus.domain)]
    if not stacks:
        print("no stack is running")
        return EXIT_FAILURE
    whole = True
    for stack in stacks:
        whole &= _show_processes(stack)
        sys.stdout.flush()
        code = run_in_front([places.program("scarab-status"), *stack.bus.arguments()], signals)
        whole &= code == 0
    return EXIT_OK if whole else EXIT_FAILURE


def _show_processes(stack: RunningStack) -> bool:
    state = "ready" if stack.ready else "starting"
    print(f"DDS domain {stack.bus.domain}, {stack.kind.value} stack, {state}: "
          f"{shown(stack.directory.path)}")
    alive = {file.stem: _restarts(file) for file in sorted(stack.directory.pids.glob("*.json"))
             if _lives(file)}
    whole = True
    for name in _expected_processes(stack.expected):
        if name in alive:
            restarts = f", restarted {alive[name]} times" if alive[name] else ""
            print(f"  {name:16} running{restarts}")
        else:
            print(f"  {name:16} NOT RUNNING; deploy/scarab logs {name}")
            whole = False
    return whole


def _expected_processes(expected: str) -> List[str]:
    names = []
    for part in expected.split(","):
        name, count = part.split("=")
        names += [name if i == 0 else f"{name}-{i}" for i in range(int(count))]
    return names


def _lives(file: Path) -> bool:
    value = read_json(file)
    return value is not None and ProcessIdentity.from_json(value).alive()


def _restarts(file: Path) -> int:
    return int((read_json(file) or {}).get("restarts", 0))


def logs(options: argparse.Namespace, places: Places) -> int:
    """Of the running stack, else of the latest run."""
    stack = choose_stack(places.runs, options.domain)
    directory = stack.directory if stack else RunDirectory((places.runs / "latest").resolve())
    files = sorted(directory.logs.glob("*.log"))
    if not files:
        raise Failure(f"there are no logs yet in {shown(places.runs)}")
    if options.service:
        names = [f.stem for f in files]
        if options.service not in names:
            raise UsageError(f"no log of '{options.service}'"
                             f"{did_you_mean(options.service, names)}; one of {', '.join(names)}")
        files = [directory.log_of(options.service)]
    if options.follow:
        os.execv("/usr/bin/tail", ["tail", "-n", str(options.lines), "-F", *map(str, files)])
    for file in files:
        if len(files) > 1:
            print(f"==> {shown(file)} <==")
        print("\n".join(last_lines(file, options.lines)))
    return EXIT_OK
