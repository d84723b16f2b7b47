"""How often a service of a stack has crashed, told by its keeper to everybody who asks."""

from dataclasses import asdict, dataclass
from pathlib import Path

from .process_identity import read_json, write_json
from .run_directory import RunDirectory


@dataclass(frozen=True)
class CrashRecord:
    """`pids/<process>.crashes`; without the file a service has never crashed."""

    restarts: int = 0     # in all
    in_a_row: int = 0     # crashes without a long good run (`restart.forget_s`) between them
    looping: bool = False  # restarting it does not help
    last_end: str = ""    # in words

    def write(self, directory: RunDirectory, process: str) -> None:
        write_json(_file(directory, process), asdict(self))

    @staticmethod
    def read(directory: RunDirectory, process: str) -> "CrashRecord":
        value = read_json(_file(directory, process))
        try:
            return CrashRecord(**value) if value else CrashRecord()
        except TypeError:
            return CrashRecord()


def _file(directory: RunDirectory, process: str) -> Path:
    return directory.pids / f"{process}.crashes"
