"""Everything that can be found wrong before anything is started, and what the run then rests on."""

import shutil
import subprocess
from pathlib import Path
from typing import Dict, Optional

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
    texts = {f"{s.name}.yaml": ask(places, s, "--dump-config") for s in stack.services}
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
    """Of the robot that the stack drives; its place is relative to the file that names it."""
    master = stack.tick_master()
    if master is None or not master.device or master.config is None:
        return None
    named = (yaml.safe_load(texts.get(f"{master.name}.yaml", "")) or {}).get("calibration")
    return master.config.parent / named if named else None


def ask(places: Places, service: Service, question: str) -> str:
    """The answer of a service's program to --check or --dump-config, with the files it would run with.

    UsageError with its one line where it refuses them, Failure where it does not answer.
    """
    command = [str(places.program(service.binary)),
               *configuration_arguments(ServiceProcess(service, 0)), question]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=_PATIENCE_S,
                              stdin=subprocess.DEVNULL, env=clean_environment(),
                              start_new_session=True, check=False)
    except subprocess.TimeoutExpired:
        raise Failure(f"{service.binary} {question} did not answer "
                      f"within {_PATIENCE_S:.0f} s") from None
    except OSError as error:
        raise Failure(f"{service.binary} cannot be executed: {error.strerror}") from None
    if done.returncode == 0:
        return done.stdout
    lines = done.stderr.strip().splitlines()
    reason = lines[-1] if lines else f"{service.binary} {question} ended with {done.returncode}"
    raise (UsageError if done.returncode == 2 else Failure)(reason)
