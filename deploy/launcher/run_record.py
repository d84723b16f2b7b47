"""`config/run.yaml` of a run directory: what was started, how, and with which files."""

import shlex
import subprocess
import sys
import time
from pathlib import Path
from typing import Dict

import yaml

from .places import shown
from .run_directory import RunDirectory
from .stack import Service, Stack
from .stack_run import StackRun

_PATIENCE_S = 30.0
_HEADING = "# What this run was started with. The resolved files of the services lie beside this one.\n"


def record_stack_run(run: StackRun, version: str) -> None:
    """Of a stack of processes."""
    record = _beginning(version)
    record |= {"pace": run.pace.value, "profile": run.stack.profile, "robot": run.stack.robot,
               "bus": {"domain": run.bus.domain, "interface": run.bus.interface,
                       "tag": run.bus.tag, "peers": list(run.bus.peers)},
               **_device(run), "services": _services(run.stack)}
    if run.stack.elsewhere:
        record["elsewhere"] = {s.name: s.instances for s in run.stack.elsewhere}
    _write(record, run.directory)


def record_simulation(stack: Stack, directory: RunDirectory, version: str) -> None:
    """Of the cores in one process."""
    record = _beginning(version)
    record |= {"pace": "one process", "robot": stack.robot, "services": _services(stack)}
    _write(record, directory)


def record_trials(directory: RunDirectory, stack_directory: RunDirectory,
                  version: str) -> None:
    """Of trials on a stack that is up, whose own record says what it consists of."""
    record = _beginning(version)
    record["stack"] = stack_directory.path.name
    _write(record, directory)


def source_version(root: Path) -> str:
    """`git describe` of the source tree, or "unknown" outside of a clone."""
    try:
        done = subprocess.run(["git", "-C", str(root), "describe", "--always", "--dirty", "--tags"],
                              capture_output=True, text=True, timeout=_PATIENCE_S, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return "unknown"
    return done.stdout.strip() or "unknown"


def _device(run: StackRun) -> Dict[str, object]:
    """Of a stack that drives one."""
    stack = run.stack
    if not stack.driver:
        return {}
    named = {"device": str(stack.device)} if stack.device else {}
    return {"driver": stack.driver, **named, "emulated": stack.emulated}


def _beginning(version: str) -> Dict[str, object]:
    return {"command": shlex.join(["scarab", *sys.argv[1:]]),
            "started": time.strftime("%Y-%m-%d %H:%M:%S %z"),
            "version": version}


def _services(stack: Stack) -> Dict[str, object]:
    return {service.name: _service(service) for service in stack.services}


def _service(service: Service) -> Dict[str, object]:
    return {"instances": service.instances, **{key: shown(file) for key, file in service.files().items()}}


def _write(record: Dict[str, object], directory: RunDirectory) -> None:
    directory.config.mkdir(exist_ok=True)
    (directory.config / "run.yaml").write_text(
        _HEADING + yaml.safe_dump(record, sort_keys=False, allow_unicode=True))
