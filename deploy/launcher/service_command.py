"""The command line of a service, one for all of them."""

from typing import List

from .places import Places
from .stack import ServiceProcess
from .stack_run import StackRun


def configuration_arguments(process: ServiceProcess) -> List[str]:
    service = process.service
    arguments: List[str] = []
    if service.robot:
        arguments += ["--robot", str(service.robot)]
    if service.config:
        arguments += ["--config", str(service.config)]
    return arguments


def service_command(places: Places, run: StackRun, process: ServiceProcess) -> List[str]:
    pace = ["--pace", run.pace.value] if process.service.tick_master else []
    return [str(places.program(process.service.binary)), *configuration_arguments(process), *pace,
            "--run-dir", str(run.directory.path), "--instance", str(process.instance),
            *run.bus.arguments(), "--expect", run.stack.expected(),
            "--log-level", run.stack.log_level]
