"""`scarab up` and `scarab down`: a stack that lasts."""

import argparse
import signal
import sys

from .domain_claim import claim_domain
from .failure import EXIT_OK, Failure
from .launch import launch
from .places import Places, shown
from .running_stack import Kind, choose_stack, end_leftovers, forget_stack
from .signals import Signals
from .stack_file import read_stack

_STOP_PATIENCE_S = 60.0


def up(options: argparse.Namespace, places: Places) -> int:
    signals = Signals()
    stack = read_stack(places.stack_file, options.profile, places.root)
    claim = claim_domain(0 if options.domain is None else options.domain)
    tag = stack.tag if options.tag is None else options.tag
    launched = launch(places, stack, claim, tag, Kind.LASTING, signals)
    launched.keeper.let_go()
    print(f"the stack is up on DDS domain {launched.bus.domain}: {stack.expected()}\n"
          f"run directory: {shown(launched.directory.path)}\n"
          "next: deploy/scarab run, deploy/scarab status, deploy/scarab topic list, "
          "deploy/scarab down")
    return EXIT_OK


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
