"""The folder of `roadlang run`, with the folders of its runs where there are several."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import msgspec

from ..falsification.statistics import FailureRate, clopper_pearson, measure_coverage
from ..ir.result_columns import OF_DRIVES, robustness_column
from ..ir.result_files import numbered_runs
from ..ir.results_record import RESULTS_FILE, ResultsRecord
from ..ir.scene import file_stem
from ..judging.badness import badness
from ..plugins.registry import Registry
from .reading import read_journal, read_record
from .results import ResultRow, Results, ShownDrive
from .shown_drives import MOST_FAILING, MOST_SAFE, shown_drive


def results_folder(folder: Path) -> Path:
    """The folder whose `provenance.json` stands for all: that of the first run of several."""
    if os.path.exists(folder / RESULTS_FILE):
        return folder
    return next(iter(_runs(folder)), folder)


def read_run(folder: Path, record: ResultsRecord, registry: Registry) -> Results:
    """The results of a run, or of all runs of a list of params. Raises `DiagnosticError` RL721."""
    runs = [folder] if os.path.exists(folder / RESULTS_FILE) else _runs(folder)
    entries = [entry for run in runs for entry in _entries(run, "" if run == folder else run.name)]
    rows = [entry.result_row(number) for number, entry in enumerate(entries)]
    failing, safe = _chosen(entries, rows)
    drives = [
        _shown(folder, entries[row.number], row, registry)
        for row in (*failing[:MOST_FAILING], *safe)
    ]
    return Results(
        record,
        tuple(dict.fromkeys(name for row in rows for name in row.robustness)),
        rows,
        drives,
        measure_coverage([(e.measures, r.has_failed) for e, r in zip(entries, rows, strict=True)]),
        _rate(runs, rows),
        more_failing=max(len(failing) - MOST_FAILING, 0),
    )


@dataclass(frozen=True)
class _Judged:
    """What is read of an expectation in the journal of a run."""

    name: str
    robustness: float | None
    satisfied: bool | None


@dataclass(frozen=True)
class _Record:
    """What is read of the verdicts of a scene there."""

    expectations: tuple[_Judged, ...]


@dataclass(frozen=True)
class _Line:
    """What is read of a line of it."""

    row: Mapping[str, Any]
    record: _Record
    measures: Mapping[str, float | None] = field(default_factory=dict)


@dataclass(frozen=True)
class _Entry:
    """A scene of a run."""

    run: str
    row: Mapping[str, Any]
    expectations: Sequence[_Judged]
    measures: Mapping[str, float | None]

    @property
    def stem(self) -> str:
        """The name of its files."""
        name = file_stem(self.row["scene"])
        return f"{self.run}/{name}" if self.run else name

    @property
    def badness(self) -> tuple[bool, bool, float]:
        """What the worst of the drives has least of."""
        found = [badness(item.satisfied, item.robustness) for item in self.expectations]
        return min(found, default=(True, True, math.inf))

    def result_row(self, number: int) -> ResultRow:
        robustness = {item.name: item.robustness for item in self.expectations}
        has_failed = any(item.satisfied is False for item in self.expectations)
        values = {"run": self.run, **self.row} if self.run else self.row
        columns = list(self.row)
        judged = [robustness_column(name, OF_DRIVES) for name in robustness]
        end = min(
            (columns.index(name) for name in [*judged, "worst"] if name in columns),
            default=len(columns),
        )
        return ResultRow(number, has_failed, values, robustness, tuple(columns[1:end]))


def _runs(folder: Path) -> list[Path]:
    return [path for path in numbered_runs(folder) if os.path.isfile(path / RESULTS_FILE)]


def _entries(folder: Path, run: str) -> Iterator[_Entry]:
    decode = msgspec.json.Decoder(_Line).decode

    def entry(line: bytes) -> tuple[int, _Entry]:
        found = decode(line)
        judged = found.record.expectations
        return int(found.row["scene"]), _Entry(run, found.row, judged, found.measures)

    latest = dict(read_journal(folder, entry))
    return iter([latest[scene] for scene in sorted(latest)])


def _chosen(
    entries: Sequence[_Entry], rows: Sequence[ResultRow]
) -> tuple[list[ResultRow], list[ResultRow]]:
    """The failing drives, the worst first, and of the others some, the nearest to failing first."""
    ordered = sorted(rows, key=lambda row: (entries[row.number].badness, row.number))
    failing = [row for row in ordered if row.has_failed]
    safe = [row for row in ordered if not row.has_failed]
    count = min(MOST_SAFE, len(safe))
    return failing, [safe[step * (len(safe) - 1) // max(count - 1, 1)] for step in range(count)]


def _shown(folder: Path, entry: _Entry, row: ResultRow, registry: Registry) -> ShownDrive:
    run = f"{entry.run}, " if entry.run else ""
    label = f"{run}scene {entry.row['scene']}"
    shown = label[0].upper() + label[1:]
    return shown_drive(folder, entry.stem, shown, row.number, row.has_failed, registry)


def _rate(runs: Sequence[Path], rows: Sequence[ResultRow]) -> FailureRate | None:
    """The rate of failures, where scenes were drawn at random and from one distribution."""
    record = read_record(runs[0])
    if len(runs) > 1 or not record.is_random_sample:
        return None
    failures = sum(row.has_failed for row in rows)
    return FailureRate(failures, len(rows), *clopper_pearson(failures, len(rows)))
