"""Which driver the robot bridge speaks to its robot with."""

from pathlib import Path
from typing import List, Optional

from .failure import UsageError
from .robot_choice import known_robots
from .strict_yaml import did_you_mean

_FOLDER = Path("config/robot_bridge")


def chosen_driver(in_file: str, wanted: Optional[str], robot: str, root: Path) -> str:
    """The one that was asked for, else that of the file. UsageError for one that has no configuration for the robot,
    naming those that have."""
    if wanted is None:
        return in_file
    known = known_drivers(root, robot)
    if wanted not in known:
        raise UsageError(f"unknown driver '{wanted}'{did_you_mean(wanted, known)}; "
                         f"for robot '{robot}' {_FOLDER} has {', '.join(known) or 'none'}")
    return wanted


def known_drivers(root: Path, robot: str) -> List[str]:
    """Those that there is a `<robot>-<driver>.yaml` of."""
    # A robot's name may begin with another's: beetle-long-loopback.yaml is not of beetle.
    longer = tuple(f"{name}-" for name in known_robots(root) if name.startswith(f"{robot}-"))
    stems = [file.stem for file in (root / _FOLDER).glob(f"{robot}-*.yaml")]
    return sorted(stem.removeprefix(f"{robot}-") for stem in stems if not stem.startswith(longer))
