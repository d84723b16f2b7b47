"""`experiment merge`: the shards of an experiment become one directory, as if it had been run at once."""

import shutil
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Dict, List, Sequence

from ..failure import UsageError
from ..places import Places, shown
from ..process_identity import write_text
from ..signals import Signals
from .directory import ExperimentDirectory
from .journal import read_journal
from .record import Record, read_record
from .report import draw_report, say_where
from .results import Result, table


@dataclass(frozen=True)
class _Part:
    directory: ExperimentDirectory
    record: Record
    results: List[Result]

    @property
    def where(self) -> str:
        return shown(self.directory.path)


def merge(paths: Sequence[Path], out: Path, fresh: bool, with_report: bool, places: Places,
          signals: Signals) -> None:
    """UsageError for directories that do not make one whole: it says which shard is missing, doubled,
    unfinished, or of something else."""
    parts = [_read(path) for path in paths]
    if out in paths:
        raise UsageError(f"{shown(out)} is one of the shards; choose another directory with --out")
    _check_same(parts)
    _check_complete(parts)
    directory = ExperimentDirectory(out)
    if directory.plan.exists() and not fresh:
        raise UsageError(f"{shown(out)} holds an experiment already; --fresh replaces it, --out DIR keeps both")
    with directory.alone():
        directory.clear()
        results = _write(parts, directory)
        print(f"{parts[0].record.name}: {len(results)} trials of {len(parts)} shards, of which "
              f"{sum(r.success for r in results)} succeeded")
        if with_report:
            draw_report(places, out, signals)
        say_where(out)


def name_of(path: Path) -> str:
    """Of the experiment that a shard is of."""
    return _read(path).record.name


def _read(path: Path) -> _Part:
    directory = ExperimentDirectory(path)
    record = read_record(directory)
    if record is None:
        raise UsageError(f"{shown(path)} has no plan.json: it is no shard of an experiment")
    if not record.shard:
        raise UsageError(f"{shown(path)} is no shard, but the whole of an experiment")
    return _Part(directory, record, read_journal(directory.journal, record.own_trials()))


def _check_same(parts: Sequence[_Part]) -> None:
    first = parts[0]
    for part in parts[1:]:
        difference = replace(part.record, shard="").difference_to(replace(first.record, shard=""))
        if difference is not None:
            raise UsageError(f"{part.where} is of another plan than {first.where}: {difference}")
        if part.record.configuration != first.record.configuration:
            raise UsageError(f"{part.where} was run with configuration {part.record.configuration}, "
                             f"{first.where} with {first.record.configuration}")
        if part.record.the_shard().of != first.record.the_shard().of:
            raise UsageError(f"{part.where} is shard {part.record.shard}, {first.where} is "
                             f"{first.record.shard}: they do not belong together")


def _check_complete(parts: Sequence[_Part]) -> None:
    found: Dict[int, _Part] = {}
    for part in parts:
        number = part.record.the_shard().number
        if number in found:
            raise UsageError(f"{found[number].where} and {part.where} are both shard {part.record.shard}")
        found[number] = part
    of = parts[0].record.the_shard().of
    missing = [f"{number}/{of}" for number in range(1, of + 1) if number not in found]
    if missing:
        raise UsageError(f"{'shards' if len(missing) > 1 else 'shard'} {', '.join(missing)} missing")
    for part in parts:
        count, all_of_them = len(part.results), len(part.record.own_trials())
        if count != all_of_them:
            raise UsageError(f"{part.where} is not finished: {count} of {all_of_them} trials; the command "
                             "that began it goes on there")


def _write(parts: Sequence[_Part], directory: ExperimentDirectory) -> List[Result]:
    first = parts[0]
    results = sorted((r for part in parts for r in part.results), key=lambda r: r.trial.index)
    versions = dict.fromkeys(session.version for part in parts for session in part.record.sessions)
    record = replace(first.record, shard="", version=", ".join(versions),
                     sessions=[session for part in parts for session in part.record.sessions])
    shutil.copytree(first.directory.config, directory.config)
    for part in parts:
        for trial in part.record.own_trials() if record.recorded else []:
            shutil.copyfile(part.directory.log_of(trial), directory.log_of(trial))
    write_text(directory.journal, "\n".join(result.line for result in results))
    write_text(directory.results, table(results, record.configuration).rstrip("\n"))
    record.write(directory)
    return results
