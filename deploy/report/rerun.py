"""Commands that run one trial again."""

from pathlib import Path

from .trial import Conditions


_SOURCE_ROOT = Path(__file__).resolve().parents[2]


def from_the_top(path: Path) -> Path:
    """As somebody at the top of the source tree names it."""
    whole = path.resolve()
    return whole.relative_to(_SOURCE_ROOT) if whole.is_relative_to(_SOURCE_ROOT) else whole


def row_command(directory: Path, trial: Conditions) -> str:
    """By its row."""
    return f"deploy/scarab sim --row {from_the_top(directory / 'results.csv')}:{trial.index}"


def rerun_command(trial: Conditions, robot: str = "") -> str:
    """Without the table: every condition is said. Empty for conditions that no options can say."""
    perturbed = (trial.perturb_position_m, trial.perturb_yaw_rad, trial.perturb_friction)
    if not trial.perturb_cpg_phase and any(perturbed):
        return ""
    words = ["deploy/scarab sim", *([f"--robot {robot}"] if robot else []), f"--strategy {trial.strategy}",
             f"--height {exact(trial.height_m)}", f"--goal {trial.goal}"]
    if trial.goal in ("travel", "walk"):
        words.append(f"--distance {exact(trial.distance_m)}")
    words += [f"--time-limit {exact(trial.time_limit_s)}", f"--seed {trial.seed}"]
    if trial.friction_scale != 1:
        words.append(f"--friction-scale {exact(trial.friction_scale)}")
    if trial.object_mass_kg:
        words.append(f"--object-mass {exact(trial.object_mass_kg)}")
    if trial.object_diameter_m:
        words.append(f"--object-diameter {exact(trial.object_diameter_m)}")
    return " ".join([*words, *_perturbation(trial)])


def exact(number: float) -> str:
    """The shortest text that is read back as the same number."""
    return str(int(number)) if number == int(number) else repr(number)


def _perturbation(trial: Conditions) -> list:
    if not trial.perturb_cpg_phase:
        return ["--no-perturbation"]
    return [f"--perturb-position {exact(trial.perturb_position_m)}", f"--perturb-yaw {exact(trial.perturb_yaw_rad)}",
            f"--perturb-friction {exact(trial.perturb_friction)}"]
