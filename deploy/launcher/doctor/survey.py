"""Short-lived participants that look around on the bus: scarab-doctor and scarab-status, all at once."""

import concurrent.futures
import json
import subprocess
from dataclasses import dataclass
from typing import Dict, List, Optional, Sequence

from ..places import Places
from ..spawn import clean_environment
from ..stack import Bus

_LOOK_S = 1.5
_PATIENCE_S = 20.0


@dataclass(frozen=True)
class Seen:
    """What was seen from one place; `fault` says why nothing could be seen."""

    bus: Bus
    participants: Sequence[dict] = ()
    mismatches: Sequence[dict] = ()
    services: Sequence[dict] = ()
    fault: str = ""


def survey(places: Places, buses: Dict[Bus, int], with_services: Sequence[Bus]) -> Dict[Bus, Seen]:
    """Looks at all buses, each with the number of participants that must be there; also asks the
    services of those in `with_services` for their status."""
    if not buses:
        return {}
    with concurrent.futures.ThreadPoolExecutor(len(buses)) as pool:
        return dict(zip(buses, pool.map(lambda bus: _look(places, bus, buses[bus],
                                                          bus in with_services), buses)))


def _look(places: Places, bus: Bus, at_least: int, with_services: bool) -> Seen:
    command = [str(places.bin / "scarab-doctor"), *bus.arguments(), "--timeout", f"{_LOOK_S:g}",
               "--participants", str(at_least)]
    asking = _start([str(places.bin / "scarab-status"), *bus.arguments(), "--json"]) \
        if with_services else None
    looking = _start(command)
    seen, fault = _answer(looking)
    services, _ = _answer(asking)
    return Seen(bus, (seen or {}).get("participants", ()), (seen or {}).get("mismatches", ()),
                (services or {}).get("services", ()), fault)


def _start(command: List[str]) -> Optional[subprocess.Popen]:
    try:
        return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, env=clean_environment())
    except OSError:  # not built, which is a finding of its own
        return None


def _answer(process: Optional[subprocess.Popen]):
    """(document or None, what it complained about)"""
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
