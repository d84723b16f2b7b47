"""The JSON of `scarab status --json`; tools/status/README.md lists its keys."""

from typing import List, Sequence

from .picture import Picture

_REPORT = ("lifecycle", "health", "message", "trial", "tick", "ticks_per_s", "counters", "histograms")


def document(pictures: Sequence[Picture], troubles: Sequence[str]) -> dict:
    return {"healthy": not troubles, "troubles": list(troubles),
            "stacks": [_stack(picture) for picture in pictures]}


def _stack(picture: Picture) -> dict:
    stack = picture.stack
    master = picture.tick_master
    return {
        "domain": stack.bus.domain, "interface": stack.bus.interface, "tag": stack.bus.tag,
        "kind": stack.kind.value, "ready": stack.ready, "pace": stack.pace.value,
        "directory": str(stack.directory.path),
        "tick_master": f"{master['service']}/{master['instance']}" if master else None,
        "trial": master["trial"] if master else None,
        "tick": master["tick"] if master else None,
        "sim_time_s": master["sim_time_s"] if master else None,
        "ticks_per_s": round(picture.ticks_per_s, 3),
        "real_time_factor": round(picture.real_time_factor, 4),
        "waits": picture.waits(),
        "refused": picture.refused(),
        "troubles": picture.troubles(),
        "processes": _processes(picture),
        "elsewhere": [_elsewhere(service) for service in picture.elsewhere],
    }


def _processes(picture: Picture) -> List[dict]:
    found = []
    for process in picture.processes:
        service = picture.services.get(process.service) if process.speaks else None
        found.append({
            "name": process.name, "pid": process.pid, "running": process.pid is not None,
            "uptime_s": round(process.uptime_s, 2), "restarts": process.crashes.restarts,
            "cpu_percent": round(picture.cpu_percent.get(process.name, 0.0), 1),
            "memory_bytes": process.memory_bytes,
            **{key: service[key] if service else None for key in _REPORT}})
    return found


def _elsewhere(service: dict) -> dict:
    return {"name": f"{service['service']}/{service['instance']}", "host": service["host"],
            "pid": service["pid"], **{key: service[key] for key in _REPORT}}
