"""Short-lived participants that look around on the bus: scarab-doctor and scarab-status."""

import json
import subprocess
from dataclasses import dataclass
from typing import Dict, List, Optional, Sequence, Tuple

from ..places import Places
from ..spawn import clean_environment
from ..stack import Bus
from .recorded import RecordedStack

_GLANCE_S = 1.0
_LOOK_S = 3.0  # at a stack; ends when all of it have been seen
_PATIENCE_S = 20.0
Answer = Tuple[Optional[dict], str]  # a document or None, and what the program complained about


@dataclass(frozen=True)
class Seen:
    """What was seen from one place; `fault` says why nothing could be seen."""

    bus: Bus
    participants: Sequence[dict] = ()
    mismatches: Sequence[dict] = ()
    fault: str = ""


def survey(places: Places, buses: Dict[Bus, int], stacks: Sequence[Bus]) -> Dict[Bus, Seen]:
    """Looks at all buses, each with the number of participants that must be there; longer, if that is
    needed to see them all, at those that are a running stack's."""
    commands = [[str(places.bin / "scarab-doctor"), *bus.arguments(), "--participants", str(count),
                 "--timeout", f"{_LOOK_S if bus in stacks else _GLANCE_S:g}"]
                for bus, count in buses.items()]
    return {bus: Seen(bus, *_parts(document, "participants", "mismatches"), fault)
            for bus, (document, fault) in zip(buses, _ask_all(commands))}


def reports(places: Places, stacks: Sequence[RecordedStack]) -> List[dict]:
    """What the services of all these stacks say of themselves."""
    commands = [[str(places.bin / "scarab-status"), *stack.bus.arguments(), "--json", "--wait",
                 stack.expected, "--timeout", f"{_LOOK_S:g}"] for stack in stacks]
    return [report for document, _ in _ask_all(commands) for report in _parts(document, "services")[0]]


def _parts(document: Optional[dict], *keys: str) -> List[Sequence[dict]]:
    return [(document or {}).get(key, ()) for key in keys]


def _ask_all(commands: Sequence[List[str]]) -> List[Answer]:
    """At the same time."""
    return [_answer(process) for process in [_start(command) for command in commands]]


def _start(command: List[str]) -> Optional[subprocess.Popen]:
    try:
        return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, env=clean_environment())
    except OSError:  # not built, which is a finding of its own
        return None


def _answer(process: Optional[subprocess.Popen]) -> Answer:
    if process is None:
        return None, ""
    try:
        out, err = process.communicate(timeout=_PATIENCE_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return None, f"it did not answer within {_PATIENCE_S:g} s"
    try:
        return json.loads(out), err.strip()
    except ValueError:
        return None, err.strip() or f"it ended with exit code {process.returncode}"


def who(party: dict) -> str:
    """`premotor/0 (scarab-premotor, pid 12 on beetle)`; other vendors tell less."""
    process = party["process"] or "a program that does not tell its name"
    if party["pid"]:
        process += f", pid {party['pid']}"
    if party["host"]:
        process += f" on {party['host']}"
    return f"{party['service']} ({process})" if party["service"] else process


def speaks_scarab(participant: dict) -> bool:
    """Whether it has endpoints on topics of the project."""
    return any(topic.startswith("scarab/") for topic in participant["topics"])
