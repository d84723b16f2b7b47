"""From a checked stack to one that runs: run directory, resolved configuration, keeper."""

import os
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Callable, Dict, List

from .device_port import check_port
from .domain_claim import DomainClaim
from .failure import Failure
from .keeper import Keeper
from .keeper_events import event_line
from .keeper_process import KeeperLine, Report, fork_keeper
from .places import Places, shown
from .preflight import check_configuration, resolved_configuration, write_configuration
from .process_identity import ProcessIdentity
from .run_directory import create_run_directory
from .run_record import record_stack_run, source_version
from .running_stack import Kind, RunningStack, forget_stack
from .service_command import service_command
from .signals import Signals
from .stack import Bus, Pace, ServiceProcess, Stack
from .stack_run import StackRun

_KEEPER_MARGIN_S = 10.0


@dataclass(frozen=True)
class Checked:
    """A stack whose services have accepted their files, and what a run of it is recorded with."""

    stack: Stack
    texts: Dict[str, str]  # file name -> resolved configuration
    version: str


@dataclass(frozen=True)
class Launched:
    """A stack with its keeper, and the line to that."""

    run: StackRun
    keeper: KeeperLine


def launch(places: Places, stack: Stack, claim: DomainClaim, pace: Pace, kind: Kind,
           signals: Signals) -> Launched:
    """Starts the stack's services and waits until they are ready; it does not wait for those elsewhere.

    UsageError before anything is started where a service refuses its configuration; Failure where the
    stack does not come up, Interrupted on a request to stop: then everything has been stopped again.
    """
    checked = check(places, stack)
    signals.raise_if_stop_requested()
    launched = begin(places, checked, claim, pace, kind, places.runs)
    _wait_until_ready(launched, signals)
    return launched


def check(places: Places, stack: Stack) -> Checked:
    """UsageError where a service refuses its configuration; Failure where a program is not built, or the port of a
    robot cannot be opened."""
    check_configuration(places, stack)
    texts = resolved_configuration(places, stack)
    check_port(stack, texts)
    return Checked(stack, texts, source_version(places.root))


def begin(places: Places, checked: Checked, claim: DomainClaim, pace: Pace, kind: Kind,
          directories: Path) -> Launched:
    """Starts the keeper, which reports "ready" or "failed"; nothing is waited for.

    The run directory is a new one in `directories`. The claim is the keeper's from here on.
    """
    stack = checked.stack
    waiter = places.program("scarab-status")
    run = StackRun(stack, Bus(claim.domain, stack.interface, stack.tag, stack.peers), pace,
                   create_run_directory(directories))
    run.directory.make_rooms()
    write_configuration(run.directory, stack, checked.texts)
    record_stack_run(run, checked.version)
    wait_ready = [str(waiter), *run.bus.arguments(), "--wait", stack.expected_here(),
                  "--timeout", f"{stack.ready_s:g}", "--progress"]
    patience_s = sum(p.service.stop_s for p in stack.processes()) + _KEEPER_MARGIN_S
    keeper = fork_keeper(_keeper_body(places, run, kind, wait_ready),
                         run.directory, kind is Kind.RUN, patience_s, claim)
    claim.release()
    return Launched(run, keeper)


def _keeper_body(places: Places, run: StackRun, kind: Kind,
                 wait_ready: List[str]) -> Callable[[Report, Signals], int]:
    def command_of(process: ServiceProcess) -> List[str]:
        return service_command(places, run, process)

    def body(report: Report, signals: Signals) -> int:
        master = run.stack.tick_master()
        running = RunningStack(kind, ProcessIdentity.of(os.getpid()), run.bus, run.directory,
                               run.stack.expected(), ready=False,
                               here=run.stack.expected_here(), pace=run.pace,
                               tick_master=master.name if master else "",
                               hardware=run.stack.hardware_here())
        running.write(places.runs)
        try:
            keeper = Keeper(run.stack, run.directory, command_of, wait_ready, report, signals)
            return keeper.run(lambda: replace(running, ready=True).write(places.runs))
        finally:
            forget_stack(places.runs, run.bus.domain)

    return body


def _wait_until_ready(launched: Launched, signals: Signals) -> None:
    reason = (f"the keeper ended unexpectedly; see "
              f"{shown(launched.run.directory.log_of('launcher'))}")
    while not launched.keeper.ended:
        for event in launched.keeper.events(signals):
            if event["event"] == "ready":
                return
            if event["event"] == "failed":
                reason = str(event["text"])
            elif event["event"] == "waiting":
                print(f"scarab: {event_line(event)}", file=sys.stderr, flush=True)
        if signals.stop_requested:
            launched.keeper.stop(signals)
            signals.raise_if_stop_requested()
    launched.keeper.stop(signals)
    raise Failure(reason)
