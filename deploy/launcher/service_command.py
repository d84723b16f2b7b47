"""The command line of a service, one for all of them."""

from typing import List

from .places import Places
from .run_directory import RunDirectory
from .stack import Bus, ServiceProcess, Stack


def configuration_arguments(process: ServiceProcess) -> List[str]:
    service = process.service
    arguments: List[str] = []
    if service.robot:
        arguments += ["--robot", str(service.robot)]
    if service.config:
        arguments += ["--config", str(service.config)]
    return arguments


def service_command(places: Places, stack: Stack, bus: Bus, directory: RunDirectory,
                    process: ServiceProcess) -> List[str]:
    return [str(places.program(process.service.binary)), *configuration_arguments(process),
            "--run-dir", str(directory.path), "--instance", str(process.instance),
            *bus.arguments(), "--expect", stack.expected(), "--log-level", stack.log_level]
