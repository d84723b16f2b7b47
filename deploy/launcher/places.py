"""Where things lie: source tree, compiled programs, run directories."""

import os
from dataclasses import dataclass
from pathlib import Path

from .failure import Failure

SOURCE_ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Places:
    """Defaults can be replaced: --bin, --runs and --stack, or SCARAB_BIN, SCARAB_RUNS, SCARAB_STACK."""

    bin: Path
    runs: Path
    stack_file: Path
    root: Path = SOURCE_ROOT

    def program(self, name: str) -> Path:
        """A compiled program; Failure where it is not built."""
        path = self.bin / name
        if not os.access(path, os.X_OK):
            raise Failure(f"{name} is not built: {shown(path)} does not exist. "
                          "Run ./deploy/demo, or build: "
                          "cmake --preset release && cmake --build --preset release")
        return path


def default_bin() -> Path:
    return Path(os.environ.get("SCARAB_BIN") or SOURCE_ROOT / "build" / "release" / "bin")


def default_runs() -> Path:
    return Path(os.environ.get("SCARAB_RUNS") or SOURCE_ROOT / "runs")


def default_stack_file() -> Path:
    return Path(os.environ.get("SCARAB_STACK") or SOURCE_ROOT / "deploy" / "stack.yaml")


def shown(path: Path) -> str:
    """The path as a person would type it: relative where that is shorter."""
    relative = os.path.relpath(path)
    return relative if len(relative) < len(str(path)) else str(path)
