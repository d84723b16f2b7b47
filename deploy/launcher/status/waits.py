"""Who waits for whom, as one sentence a chain, from what the waiting services say."""

import re
from typing import Dict, Iterable, List, Sequence


def waits(services: Sequence[dict], expected: Iterable[str]) -> List[str]:
    """`plant/0 waits for supervisor/0, which waits for premotor/0, which says nothing`.

    `services` as scarab-status has them; `expected` the names (plant, premotor) of all there should be.
    """
    by_name = {name_of(s): s for s in services}
    waiting = {name: s for name, s in by_name.items() if s["health"] == "waiting"}
    targets = {name: _mentioned(s["message"], name, expected) for name, s in waiting.items()}
    awaited = {target for wanted in targets.values() for target in wanted}
    first = [name for name in waiting if name not in awaited] or list(waiting)[:1]
    return [_sentence(name, waiting, targets, by_name) for name in first]


def name_of(service: dict) -> str:
    return f"{service['service']}/{service['instance']}"


def _mentioned(message: str, speaker: str, expected: Iterable[str]) -> List[str]:
    """The others that a message names: `premotor/0`, or `premotor` alone."""
    names = "|".join(sorted(map(re.escape, expected), key=len, reverse=True))
    found: Dict[str, None] = {}
    for match in re.finditer(rf"(?<![\w/])({names})(?:/(\d+))?(?![\w/])", message) if names else ():
        found.setdefault(f"{match[1]}/{match[2] or 0}")
    return [name for name in found if name != speaker]


def _sentence(name: str, waiting: Dict[str, dict], targets: Dict[str, List[str]],
              by_name: Dict[str, dict]) -> str:
    if not targets[name]:
        return f"{name}: {waiting[name]['message']}"
    seen = [name]
    text = f"{name} waits for {join(targets[name])}"
    while True:
        *_, last = seen
        (next_one, *others) = targets[last]
        if others or next_one in seen:
            return text + _states([next_one, *others], waiting, by_name)
        if not targets.get(next_one):
            return text + _states([next_one], waiting, by_name)
        text += f", which waits for {join(targets[next_one])}"
        seen.append(next_one)


def _states(names: List[str], waiting: Dict[str, dict], by_name: Dict[str, dict]) -> str:
    """What is to be known of those at the end of a chain."""
    text = ""
    for name in names:
        which = "which" if len(names) == 1 else name
        if name not in by_name:
            text += f", {which} says nothing"
        elif by_name[name]["health"] == "fault":
            text += f", {which} has a fault: {by_name[name]['message']}"
        elif name in waiting and len(names) > 1:
            text += f", {which} waits itself"
    return text


def join(names: Sequence[str]) -> str:
    """`a, b and c`"""
    *but_last, last = names
    return f"{', '.join(but_last)} and {last}" if but_last else last
