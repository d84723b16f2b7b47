"""What killed launchers left behind, and stacks that are half up."""

from typing import List

from ..places import shown
from ..process_identity import ProcessIdentity, read_json
from .finding import Finding, note, ok, problem
from .recorded import RecordedStack
from .subject import Subject


def leftovers(subject: Subject) -> List[Finding]:
    found = [_dead(s) for s in subject.recorded if not s.alive()]
    found += [note(f"the stack on DDS domain {s.bus.domain} is starting or stopping "
                   f"({shown(s.directory.path)})") for s in subject.running if not s.ready]
    return found or [ok("none")]


def _dead(stack: RecordedStack) -> Finding:
    living = [f"{name} (pid {process.pid})" for name, process in _services(stack)
              if process.alive()]
    still = f"; still running: {', '.join(living)}" if living else ""
    return problem(f"the keeper (pid {stack.keeper.pid}) of the stack on DDS domain "
                   f"{stack.bus.domain} was killed and left {shown(stack.file)}{still}",
                   f"deploy/scarab down --domain {stack.bus.domain} ends and clears away all of it.")


def _services(stack: RecordedStack):
    for file in sorted(stack.directory.pids.glob("*.json")):
        value = read_json(file)
        if value is not None:
            yield file.stem, ProcessIdentity.from_json(value)
