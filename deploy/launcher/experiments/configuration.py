"""What the robot, the plant and the controllers of an experiment are: resolved files, and a digest of them."""

import hashlib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Dict, List

from ..failure import UsageError
from ..places import Places
from ..preflight import check_configuration, resolved_configuration, resolved_file
from ..stack import Stack

SIMULATED = ("plant", "premotor", "supervisor")
_ROBOT = "robot.yaml"
_DIGITS = 8


@dataclass(frozen=True)
class Configuration:
    """File name -> text, with all that the files extend and every default."""

    robot: str
    texts: Dict[str, str]

    def digest(self) -> str:
        """8 hexadecimal digits."""
        whole = hashlib.sha256()
        for name in sorted(self.texts):
            whole.update(f"{name}\0{self.texts[name]}\0".encode())
        return whole.hexdigest()[:_DIGITS]

    def write(self, directory: Path) -> None:
        directory.mkdir(exist_ok=True)
        for name, text in self.texts.items():
            (directory / name).write_text(text)

    def files_that_differ(self, directory: Path) -> List[str]:
        """Names of those that have another text there."""
        return [name for name, text in sorted(self.texts.items()) if _text(directory / name) != text]


def resolve_configuration(places: Places, stack: Stack) -> Configuration:
    """Of the stack's plant, premotor controller and supervisor, which check their files first.

    UsageError with the one line of a service that refuses its file; Failure where a program does not answer.
    """
    cores = stack.only(SIMULATED)
    for name in SIMULATED:
        service = cores.service(name)
        if service is None or service.config is None:
            raise UsageError(f"{stack.file}: an experiment needs the config of service '{name}'")
    check_configuration(places, cores)
    texts = resolved_configuration(places, cores)
    robots = {str(service.robot): service.robot for service in cores.services if service.robot}
    if len(robots) != 1:
        raise UsageError(f"{stack.file}: an experiment needs one robot file, the same for plant and premotor")
    texts[_ROBOT] = resolved_file(places, "robot", *robots.values())
    return Configuration(stack.robot, texts)


def stack_that_reads(stack: Stack, directory: Path) -> Stack:
    """The stack with the files that Configuration.write has left there, which nobody edits meanwhile. The logger's,
    which changes nothing of a result, is not among them."""
    def changed(service):
        if service.name not in SIMULATED:
            return service
        return replace(service, robot=directory / _ROBOT if service.robot else None,
                       config=directory / f"{service.name}.yaml" if service.config else None)

    return replace(stack, services=tuple(changed(s) for s in stack.services))


def simulation_arguments(directory: Path) -> List[str]:
    """The same files for scarab-sim."""
    arguments = ["--robot", str(directory / _ROBOT)]
    for name in SIMULATED:
        arguments += [f"--{name}", str(directory / f"{name}.yaml")]
    return arguments


def _text(file: Path) -> str:
    try:
        return file.read_text()
    except OSError:
        return ""
