"""The command line of a service, one for all of them."""

from pathlib import Path
from typing import List, Optional

from .places import Places
from .stack import ServiceProcess
from .stack_run import StackRun


def configuration_arguments(process: ServiceProcess) -> List[str]:
    return [word for option, file in process.service.files().items()
            for word in (f"--{option}", str(file))]


def service_command(places: Places, run: StackRun, process: ServiceProcess) -> List[str]:
    pace = ["--pace", run.pace.value] if process.service.tick_master else []
    device = _device(run) if process.service.device or process.service.hardware else None
    return [str(places.program(process.service.binary)), *configuration_arguments(process), *pace,
            *(["--device", str(device)] if device else []),
            "--run-dir", str(run.directory.path), "--instance", str(process.instance),
            *run.bus.arguments(), "--expect", run.stack.expected(),
            "--log-level", run.stack.log_level]


def _device(run: StackRun) -> Optional[Path]:
    """None: as configured."""
    return run.directory.device if run.stack.emulated else run.stack.device
