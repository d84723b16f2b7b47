"""What a person may say to `scarab calibrate` in place of the files that its program reads."""

from typing import List, Optional, Tuple

from .failure import UsageError
from .places import Places
from .robot_choice import known_robots
from .stack_changes import StackChanges
from .stack_file import read_stack
from .stack_options import ROBOT_PROFILE

OWN_OPTIONS = ("--driver",)


def calibrate_words(words: List[str], places: Places) -> List[str]:
    """The words for scarab-calibrate: `--robot NAME` and `--driver NAME`, or what stack.yaml says, stand for files.

    UsageError for names that are not there, and for both a driver and a file.
    """
    if "--help" in words or "-h" in words:
        return words
    driver, without_driver = _taken("--driver", words)
    robot, rest = _taken("--robot", without_driver)
    config, _ = _taken("--config", words)
    if config is not None and driver is not None:
        raise UsageError("scarab calibrate: --driver and --config contradict each other: both say which file is read")
    if config is not None and robot is not None and robot not in known_robots(places.root):
        return words  # both are files, as the program takes them
    stack = read_stack(places.stack_file, ROBOT_PROFILE, places.root, StackChanges(robot=robot, driver=driver))
    bridge = stack.tick_master()
    if bridge is None:
        raise UsageError(f"{stack.file}: profile '{ROBOT_PROFILE}' starts no bridge here")
    return ["--robot", str(bridge.robot), *(["--config", str(bridge.config)] if config is None else []), *rest]


def _taken(option: str, words: List[str]) -> Tuple[Optional[str], List[str]]:
    """Its value, None without one, and the other words."""
    for at, word in enumerate(words):
        if word == option and at + 1 < len(words):
            return words[at + 1], words[:at] + words[at + 2:]
        if word.startswith(option + "="):
            return word.partition("=")[2], words[:at] + words[at + 1:]
    return None, words
