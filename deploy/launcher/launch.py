"""From a checked stack to one that runs: run directory, resolved configuration, keeper."""

import os
from dataclasses import dataclass, replace
from typing import Callable, Dict, List

from .domain_claim import DomainClaim
from .failure import Failure
from .keeper import Keeper
from .keeper_process import KeeperLine, Report, fork_keeper
from .places import Places, shown
from .preflight import (check_configuration, resolved_configuration, source_version,
                        write_configuration)
from .process_identity import ProcessIdentity
from .run_directory import RunDirectory, create_run_directory
from .running_stack import Kind, RunningStack, forget_stack
from .service_command import service_command
from .signals import Signals
from .stack import Bus, ServiceProcess, Stack

_KEEPER_MARGIN_S = 10.0


@dataclass(frozen=True)
class Launched:
    """A stack that is ready, and the line to its keeper."""

    stack: Stack
    bus: Bus
    directory: RunDirectory
    keeper: KeeperLine


def launch(places: Places, stack: Stack, claim: DomainClaim, tag: str, kind: Kind,
           signals: Signals) -> Launched:
    """Starts the stack and waits until it is ready.

    UsageError before anything is started where a service refuses its configuration; Failure where the
    stack does not come up, Interrupted on a request to stop: then everything has been stopped again.
    """
    check_configuration(places, stack)
    texts = resolved_configuration(places, stack)
    waiter = places.program("scarab-status")
    signals.raise_if_stop_requested()
    bus = Bus(claim.domain, stack.interface, tag)
    directory = create_run_directory(places.runs)
    directory.make_rooms()
    write_configuration(directory, stack, texts, source_version(places.root))
    wait_ready = [str(waiter), *bus.arguments(), "--wait", stack.expected(),
                  "--timeout", f"{stack.ready_s:g}"]
    body = _keeper_body(places, stack, bus, directory, kind, wait_ready)
    patience_s = sum(p.service.stop_s for p in stack.processes()) + _KEEPER_MARGIN_S
    keeper = fork_keeper(body, directory.log_of("launcher"), kind is Kind.RUN, patience_s)
    claim.release()  # the keeper holds it from here on
    launched = Launched(stack, bus, directory, keeper)
    _wait_until_ready(launched, signals)
    return launched


def _keeper_body(places: Places, stack: Stack, bus: Bus, directory: RunDirectory, kind: Kind,
                 wait_ready: List[str]) -> Callable[[Report, Signals], int]:
    def command_of(process: ServiceProcess) -> List[str]:
        return service_command(places, stack, bus, directory, process)

    def body(report: Report, signals: Signals) -> int:
        running = RunningStack(kind, ProcessIdentity.of(os.getpid()), bus, directory,
                               stack.expected(), ready=False)
        running.write(places.runs)
        try:
            keeper = Keeper(stack, directory, command_of, wait_ready, report, signals)
            return keeper.run(lambda: replace(running, ready=True).write(places.runs))
        finally:
            forget_stack(places.runs, bus.domain)

    return body


def _wait_until_ready(launched: Launched, signals: Signals) -> None:
    reason = (f"the keeper ended unexpectedly; see "
              f"{shown(launched.directory.log_of('launcher'))}")
    while not launched.keeper.ended:
        for event in launched.keeper.events(signals):
            if event["event"] == "ready":
                return
            if event["event"] == "failed":
                reason = str(event["text"])
        if signals.stop_requested:
            launched.keeper.stop(signals)
            signals.raise_if_stop_requested()
    launched.keeper.stop(signals)
    raise Failure(reason)


def event_line(event: Dict[str, object]) -> str:
    """What a person should read of an event of the keeper; empty for the everyday ones."""
    name = event.get("service", "")
    kind = event["event"]
    if kind == "crashed":
        return f"{name} {event['text']}; restart {event['restart']} follows"
    if kind == "lost":
        return f"{name} {event['text']}; it is not restarted"
    if kind == "killed":
        return f"{name} did not stop within {event['after_s']:g} s and was killed"
    if kind == "unstartable":
        return f"{name} cannot be restarted now: {event['text']}"
    return ""
