"""The robot that a running stack drives, as its run directory tells: whatever options it was started with."""

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Optional

import yaml

from ..run_directory import RunDirectory


@dataclass(frozen=True)
class Driven:
    """`port` is None where the driver opens none."""

    bridge: str  # the service
    driver: str
    emulated: bool
    port: Optional[Path]


def driven_by(directory: RunDirectory) -> Optional[Driven]:
    """None for a stack that drives no robot on this host."""
    record = _mapping(directory.config / "run.yaml")
    for service in record.get("services") or {}:
        resolved = _mapping(directory.config / f"{service}.yaml")
        driver = str(resolved.get("driver") or "")
        if driver:
            emulated = bool(record.get("emulated"))
            port = (directory.device if emulated else
                    record.get("device") or (resolved.get(driver) or {}).get("port"))
            return Driven(service, driver, emulated, Path(port) if port else None)
    return None


def _mapping(file: Path) -> Dict[str, object]:
    """Empty for a file that is not there or is not whole yet."""
    try:
        value = yaml.safe_load(file.read_text())
    except (OSError, UnicodeDecodeError, yaml.YAMLError):
        return {}
    return value if isinstance(value, dict) else {}
