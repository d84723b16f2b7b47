"""`scarab up` and `scarab down`: a stack that lasts."""

import argparse
import signal
import subprocess
import sys

from .domain_claim import claim_domain
from .failure import EXIT_OK, Failure
from .launch import Launched, launch
from .pace_choice import choose_pace
from .places import Places, shown
from .running_stack import Kind, choose_stack, end_leftovers, forget_stack
from .signals import Signals
from .spawn import clean_environment
from .stack import Pace
from .stack_file import read_stack
from .stack_options import add_pace_options, add_stack_options, changes_of
from .verbs import Verbs

_STOP_PATIENCE_S = 60.0
_ELSEWHERE_PATIENCE_S = 3.0


_UP_MORE = """It goes by the wall clock, as a robot does, until `deploy/scarab down`. Trials are run on it by
`deploy/scarab run`. With a profile that has services elsewhere (plant-host, robot-host, ...) it starts
those of this host, and says whom it misses on the other one."""
_UP_EXAMPLES = """deploy/scarab up
deploy/scarab up --lockstep --replicas premotor=2
deploy/scarab up --profile robot --driver dynamixel --device /dev/ttyUSB1
deploy/scarab up --profile plant-host --interface eth0"""
_DOWN_MORE = """The trial that runs on it fails; its log is closed. To end the trial alone and keep the stack:
`deploy/scarab stop`."""


def add_verbs(verbs: Verbs) -> None:
    parser = verbs.add("up", up, "start a stack that stays, and wait until it is ready",
                       _UP_EXAMPLES, _UP_MORE)
    add_stack_options(parser)
    add_pace_options(parser, Pace.REALTIME)
    verbs.add("down", down, "stop a running stack, the logger last (`stop` ends a trial only)",
              "deploy/scarab down", _DOWN_MORE)


def up(options: argparse.Namespace, places: Places) -> int:
    signals = Signals()
    stack = read_stack(places.stack_file, options.profile, places.root, changes_of(options))
    pace = choose_pace(stack, options.pace, Pace.REALTIME)
    claim = claim_domain(0 if options.domain is None else options.domain)
    launched = launch(places, stack, claim, pace, Kind.LASTING, signals)
    launched.keeper.let_go()
    run = launched.run
    how = f", {run.pace.words}" if stack.tick_master() else ""  # else the other host's to say
    print(f"the stack is up on DDS domain {run.bus.domain}{how}: {stack.expected_here()}")
    if stack.hardware_here():
        print(f"emulated hardware: {stack.hardware_here()}")
    if stack.elsewhere:
        print(_elsewhere(launched, places))
    print(f"run directory: {shown(run.directory.path)}\n"
          "next: deploy/scarab run, deploy/scarab status, deploy/scarab topic list, "
          "deploy/scarab down")
    return EXIT_OK


def _elsewhere(launched: Launched, places: Places) -> str:
    """Who of the services on other hosts is there already: they may well be started later."""
    bus, expected = launched.run.bus, launched.run.stack.expected_elsewhere()
    command = [str(places.program("scarab-status")), *bus.arguments(), "--wait", expected,
               "--timeout", f"{_ELSEWHERE_PATIENCE_S:g}"]
    asked = subprocess.run(command, capture_output=True, text=True, check=False,
                           stdin=subprocess.DEVNULL, env=clean_environment())
    if asked.returncode == 0:
        return f"elsewhere: {expected}, all there"
    answer = asked.stderr.strip().splitlines() or ["nobody answers"]
    what_to_do = (f"start them on their host, on DDS domain {bus.domain}; trials begin when all are there"
                  if bus.interface != "lo" else
                  "lo reaches no other host: choose the interface they share with --interface NAME")
    return (f"elsewhere: {expected}; not yet: {answer[-1].removeprefix('scarab-status: ')}\n"
            f"           {what_to_do}")


def down(options: argparse.Namespace, places: Places) -> int:
    """Stops a stack; of a `run` too, which then ends as if by Ctrl-C. No stack is no error."""
    Signals()  # Ctrl-C does not leave a stack half stopped
    stack = choose_stack(places.runs, options.domain)
    if stack is None:
        print("no stack is running")
        return EXIT_OK
    stack.keeper.signal(signal.SIGTERM)
    if not stack.keeper.wait_end(_STOP_PATIENCE_S):
        print(f"scarab: the keeper did not stop within {_STOP_PATIENCE_S:g} s; ending what is left",
              file=sys.stderr)
        stack.keeper.signal(signal.SIGKILL)
        stack.keeper.wait_end(_STOP_PATIENCE_S)
        killed = end_leftovers(stack.directory)
        forget_stack(places.runs, stack.bus.domain)
        raise Failure(f"killed: {', '.join(killed) or 'the keeper'}")
    print(f"stopped; its run directory is {shown(stack.directory.path)}")
    return EXIT_OK
