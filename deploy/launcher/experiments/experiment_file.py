"""Reads config/experiments/NAME.yaml: its shape is declared, what its parts say of each other is here."""

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Sequence, Tuple

from ..failure import UsageError
from ..strict_yaml import Value, did_you_mean, read_yaml
from .declaration import DEFAULTS, EXPERIMENT, MOST_SEED, SCENE

EXPERIMENT_WORDS = ("list", "all", "merge")  # in place of a name
FOLDER = Path("config/experiments")
_ENDING = ".yaml"


@dataclass(frozen=True)
class Grid:
    """Every combination of these values."""

    lists: Dict[str, List[object]]


@dataclass(frozen=True)
class Perturbation:
    """Of the start of every trial: uniform in +- these, by the trial's seed."""

    position_m: float
    yaw_rad: float
    friction: float
    cpg_phase: bool


@dataclass(frozen=True)
class Experiment:
    """A file's plain values."""

    name: str
    title: str
    figure: str
    paper: Tuple[str, ...]
    grids: Tuple[Grid, ...]
    every_trial: Dict[str, object]  # has whatever a grid does not have
    trials: int
    first_seed: int
    perturbation: Perturbation
    paper_figure: str = ""
    notes: Tuple[str, ...] = ()
    record: bool = False


def known_experiments(root: Path) -> List[str]:
    return sorted(file.stem for file in (root / FOLDER).glob(f"*{_ENDING}"))


def find_experiment(word: str, root: Path) -> Path:
    """The file of a name, or the file itself. UsageError for what is neither, with what may have been
    meant."""
    if word.endswith(_ENDING):
        if not Path(word).is_file():
            raise UsageError(f"there is no file {word}")
        return Path(word)
    known = known_experiments(root)
    if word not in known:
        raise UsageError(f"unknown experiment '{word}'{did_you_mean(word, known)}; one of {', '.join(known)}")
    return root / FOLDER / f"{word}{_ENDING}"


def read_experiment(file: Path) -> Experiment:
    """ConfigError for a mistake anywhere in the file."""
    value = read_yaml(file)
    read = EXPERIMENT.read(value)
    grids = value.at("grids").sequence()
    for grid, place in zip(read["grids"], grids):
        _check_grid(grid, place, read["every_trial"])
    _check_seeds(read, value)
    _check_perturbation(read["perturbation"], value.at("perturbation"))
    return Experiment(
        name=file.stem, title=read["title"], figure=read["figure"], paper=tuple(read["paper"]),
        grids=tuple(Grid(grid) for grid in read["grids"]),
        every_trial={**DEFAULTS, **read["every_trial"]},
        trials=read["trials"], first_seed=read["first_seed"],
        perturbation=Perturbation(**read["perturbation"]),
        paper_figure=read.get("paper_figure", ""), notes=tuple(read.get("notes", ())),
        record=read.get("record", False))


def _check_grid(grid: Dict[str, List[object]], place: Value, every_trial: Dict[str, object]) -> None:
    """Each part of a trial is said once, and no combination is impossible."""
    for name, values in grid.items():
        if name in every_trial:
            place.at(name).fail("is in every_trial, too: one of the two has to go")
        if len(set(values)) != len(values):
            place.at(name).fail("names a value twice")
    for name in SCENE:
        if name not in grid and name not in every_trial and name not in DEFAULTS:
            place.fail(f"neither the grid nor every_trial says {name}")
    _check_goals(grid, place, every_trial)


def _check_goals(grid: Dict[str, List[object]], place: Value, every_trial: Dict[str, object]) -> None:
    goals, heights = (grid.get(name, [every_trial.get(name)]) for name in ("goal", "height_m"))
    if "across" in goals and 0.0 in heights:
        place.fail("goal across needs an obstacle: height_m greater than 0")


def _check_seeds(read: Dict[str, object], value: Value) -> None:
    if read["first_seed"] + read["trials"] - 1 > MOST_SEED:
        value.at("first_seed").fail(f"leaves no {read['trials']} seeds: the last one would be above "
                                    f"{MOST_SEED}")


def _check_perturbation(read: Dict[str, object], value: Value) -> None:
    others: Sequence[str] = [name for name in ("position_m", "yaw_rad", "friction") if read[name]]
    if others and not read["cpg_phase"]:  # `run --no-perturbation` means all four
        value.at("cpg_phase").fail(f"false, although {others[0]} is perturbed: a row of such a trial could "
                                   "not be run again with the options of `scarab run`")
