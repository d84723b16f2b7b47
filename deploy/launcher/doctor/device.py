"""The port of a robot: that it is there, that it may be opened, and that nobody else has it."""

from pathlib import Path
from typing import List

from ..device_port import holders_of, obstacle_at, port_of
from ..failure import Failure
from ..preflight import ask
from ..process_identity import ProcessIdentity, read_json
from .finding import Finding, note, ok, problem
from .subject import Subject


def device(subject: Subject) -> List[Finding]:
    stack = subject.stack
    master = stack.tick_master() if stack else None
    if stack is None or master is None or not master.device:
        return [ok("the profile drives no robot")]
    try:
        resolved = ask(subject.places, master, "--dump-config")
    except Failure as refused:
        return [note(f"not looked at: {refused}")]
    port = port_of(stack, {f"{master.name}.yaml": resolved})
    if port is None:
        return [ok(f"driver {stack.driver} opens no port")]
    holder = _bridge_of_ours(subject, port)
    if holder:
        return [ok(f"{port} is open in {holder} of the stack that is up")]
    obstacle = obstacle_at(port)
    if obstacle:
        return [problem(obstacle.what, f"{obstacle.advice}.")]
    return [ok(f"{port} is there, may be opened, and is free")]


def _bridge_of_ours(subject: Subject, port: Path) -> str:
    """The process of a running stack of this source tree that alone has the port open; empty where none has."""
    ours = set()
    for stack in subject.running:
        for file in stack.directory.pids.glob("*.json"):
            value = read_json(file)
            if value is not None:
                ours.add(ProcessIdentity.from_json(value).pid)
    holders = holders_of(port)
    return str(holders[0]) if holders and all(h.pid in ours for h in holders) else ""
