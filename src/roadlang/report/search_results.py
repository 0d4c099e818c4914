"""The folder of `roadlang falsify`."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from ..falsification.outcome import Outcome
from ..falsification.outcome_rows import places_of, row_of
from ..falsification.statistics import best_so_far, coverage, failure_rate
from ..ir.result_columns import OF_SEARCH, value_columns
from ..ir.result_files import FAILURES, INDEX, SAFE, SUMMARY
from ..ir.results_record import ResultsRecord
from ..plugins.registry import Registry
from .reading import read_journal, read_typed
from .results import ResultRow, Results, ShownDrive
from .shown_drives import MOST_FAILING, shown_drive


@dataclass(frozen=True)
class _Summary:
    """What is read of `summary.json`."""

    evaluations: int


@dataclass(frozen=True)
class _Item:
    """A scene of an index."""

    scene: str
    evaluation: int

    @property
    def stem(self) -> str:
        return self.scene.removesuffix(".json")


@dataclass(frozen=True)
class _Failures:
    """What is read of `failures/index.json`."""

    axes: tuple[str, ...]
    failures: tuple[_Item, ...]


@dataclass(frozen=True)
class _Safe:
    """What is read of `safe/index.json`."""

    safe: tuple[_Item, ...]


def read_search(folder: Path, record: ResultsRecord, registry: Registry) -> Results:
    """The results of a search. Raises `DiagnosticError` RL721."""
    evaluations = read_typed(folder / SUMMARY, _Summary).evaluations
    index = read_typed(folder / FAILURES / INDEX, _Failures)
    failures, axes = index.failures, index.axes
    outcomes = _outcomes(folder, evaluations)
    driven = [outcome for outcome in outcomes if outcome.is_valid]
    places = places_of(outcomes)
    rows = [_row(outcome, axes, places) for outcome in driven]
    expects = record.expects
    drives = [*_failures(folder, failures, expects, registry), *_safe(folder, expects, registry)]
    rate = failure_rate(outcomes)
    return Results(
        record,
        record.expects,
        rows,
        drives,
        coverage(outcomes),
        rate if rate.scenes else None,
        len(outcomes),
        len(failures),
        {name: best_so_far(outcomes, name) for name in record.expects},
        max(len(failures) - MOST_FAILING, 0),
    )


def _outcomes(folder: Path, evaluations: int) -> Sequence[Outcome]:
    found = read_journal(folder, msgspec.json.Decoder(Outcome).decode)
    latest = {outcome.index: outcome for outcome in found if outcome.index < evaluations}
    return [latest[number] for number in sorted(latest)]


def _row(outcome: Outcome, axes: Sequence[str], places: Container[str]) -> ResultRow:
    draws = value_columns(dict.fromkeys([*outcome.draws, *axes]), OF_SEARCH)
    values = row_of(outcome, axes, places)
    named = tuple(name for name in draws if name in values)
    return ResultRow(outcome.index, outcome.is_failure, values, outcome.expectations, named)


def _failures(
    folder: Path, failures: Sequence[_Item], expects: tuple[str, ...], registry: Registry
) -> Iterator[ShownDrive]:
    for rank, item in enumerate(failures[:MOST_FAILING], 1):
        name, label = f"{FAILURES}/{item.stem}", f"Failure {rank}"
        yield shown_drive(folder, name, label, item.evaluation, True, registry, expects)


def _safe(folder: Path, expects: tuple[str, ...], registry: Registry) -> Iterator[ShownDrive]:
    path = folder / SAFE / INDEX
    listed = read_typed(path, _Safe).safe if path.is_file() else ()
    for rank, item in enumerate(listed, 1):
        name, label = f"{SAFE}/{item.stem}", f"Safe {rank}"
        yield shown_drive(folder, name, label, item.evaluation, False, registry, expects)
