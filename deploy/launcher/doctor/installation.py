"""Programs that are not built, files that their services refuse."""

import os
from typing import List

from ..failure import Failure
from ..places import shown
from ..preflight import check_configuration
from .finding import Finding, note, ok, problem
from .subject import Subject

_TOOLS = ("scarab-experiment", "scarab-status", "scarab-doctor", "scarab-topic", "scarab-log",
          "scarab-operator", "scarab-sim")


def programs(subject: Subject) -> List[Finding]:
    services = subject.stack.services if subject.stack else ()
    names = [*(s.binary for s in services), *_TOOLS]
    place = subject.places.bin
    missing = [name for name in names if not os.access(place / name, os.X_OK)]
    if missing:
        return [problem(f"not built in {shown(place)}: {', '.join(missing)}",
                        "Run ./deploy/demo, or cmake --build --preset release.")]
    return [ok(f"{len(names)} programs in {shown(place)}")]


def configuration(subject: Subject) -> List[Finding]:
    if subject.stack is None:
        return [problem(str(subject.stack_fault), "Mend that line; nothing can be started before.")]
    if any(not os.access(subject.places.bin / s.binary, os.X_OK) for s in subject.stack.services):
        return [note("not looked at: the services' programs are not all built")]
    try:
        check_configuration(subject.places, subject.stack)
    except Failure as refused:
        return [problem(str(refused), "Mend it; nothing can be started before.")]
    return [ok(f"{shown(subject.places.stack_file)} and the files it names are valid")]
