"""Everything that can be found wrong before anything is started, and what the run then rests on."""

import shutil
import subprocess
from pathlib import Path
from typing import Dict, Optional, Sequence, Union

import yaml

from .failure import Failure, UsageError
from .places import Places
from .run_directory import RunDirectory
from .service_command import configuration_arguments
from .spawn import clean_environment
from .stack import Service, ServiceProcess, Stack

_PATIENCE_S = 30.0


def check_configuration(places: Places, stack: Stack) -> None:
    """Lets each service validate its own files. UsageError with its one line at the first that refuses."""
    for service in stack.services:
        ask(places, service, "--check")


def resolved_configuration(places: Places, stack: Stack) -> Dict[str, str]:
    """File name -> text of what each service will run with, defaults and all."""
    texts = {f"{s.name}.yaml": ask(places, s, "--dump-config") for s in stack.services if not s.hardware}
    # Hardware reads the files of its tick master; what is behind it is the same plant as elsewhere.
    texts |= {"plant.yaml": resolved_file(places, "plant", s.plant) for s in stack.services if s.plant}
    return {name: text for name, text in texts.items() if text.strip()}


def write_configuration(directory: RunDirectory, stack: Stack, texts: Dict[str, str]) -> None:
    """Fills `config/` of the run directory, which the logger attaches to its log."""
    directory.config.mkdir(exist_ok=True)
    for name, text in texts.items():
        (directory.config / name).write_text(text)
    shutil.copyfile(stack.file, directory.config / "stack.yaml")
    for robot in {s.robot for s in stack.services if s.robot}:
        shutil.copyfile(robot, directory.config / f"robot-{robot.name}")
    calibration = _calibration(stack, texts)
    if calibration:
        shutil.copyfile(calibration, directory.config / f"calibration-{calibration.name}")


def _calibration(stack: Stack, texts: Dict[str, str]) -> Optional[Path]:
    """Of the robot that the stack drives, as its bridge resolves the path."""
    master = stack.tick_master()
    if master is None or not master.device:
        return None
    named = (yaml.safe_load(texts.get(f"{master.name}.yaml", "")) or {}).get("calibration")
    return Path(named) if named else None


def ask(places: Places, service: Service, question: str) -> str:
    """The answer of a service's program to --check or --dump-config, with the files it would run with.

    UsageError with its one line where it refuses them, Failure where it does not answer.
    """
    return _answer(f"{service.binary} {question}",
                   [places.program(service.binary), *configuration_arguments(ServiceProcess(service, 0)), question])


def resolved_file(places: Places, kind: str, file: Path) -> str:
    """A file with all that it extends and every default, by scarab-config. Fails as ask() does."""
    return _answer("scarab-config dump", [places.program("scarab-config"), "dump", "--kind", kind, file])


def _answer(name: str, command: Sequence[Union[str, Path]]) -> str:
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=_PATIENCE_S,
                              stdin=subprocess.DEVNULL, env=clean_environment(),
                              start_new_session=True, check=False)
    except subprocess.TimeoutExpired:
        raise Failure(f"{name} did not answer within {_PATIENCE_S:.0f} s") from None
    except OSError as error:
        raise Failure(f"{name} cannot be executed: {error.strerror}") from None
    if done.returncode == 0:
        return done.stdout
    lines = done.stderr.strip().splitlines()
    reason = lines[-1] if lines else f"{name} ended with {done.returncode}"
    raise (UsageError if done.returncode == 2 else Failure)(reason)
