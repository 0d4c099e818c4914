"""What was drawn while candidates were evaluated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from .candidate_rows import rows_of

T = TypeVar("T")


@dataclass(frozen=True)
class DrawRecord:
    """Filled by the `CandidateBatch` that it is passed to.

    Names are places of draws, with the number of the road or copy where there are several:
    `bent/perturb 1/amplitude`, `tree/at[2]`.
    """

    coordinates: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    """(V,) numbers in [0, 1) that draws and passes were made from"""
    values: dict[str, Any] = field(default_factory=dict)
    """(V, 1) what was drawn"""
    absent: dict[str, NDArray[np.bool_]] = field(default_factory=dict)
    """(V,) candidates that do not have a draw: those of copies that only others have"""

    def take(self, rows: NDArray[np.intp], count: int) -> DrawRecord:
        """What the candidates at `rows` of `count` have drawn."""
        absent = {name: rows_of(value, rows, count) for name, value in self.absent.items()}
        missing = {name for name, value in absent.items() if value.all()}
        coordinates, values = (
            {
                name: rows_of(value, rows, count)
                for name, value in found.items()
                if name not in missing
            }
            for found in (self.coordinates, self.values)
        )
        partly = {
            name: value for name, value in absent.items() if name not in missing and value.any()
        }
        return DrawRecord(coordinates, values, partly)

    def add_alone(self, records: Mapping[int, DrawRecord], count: int) -> None:
        """Add what single candidates, by row of `count`, have drawn that is not here yet."""
        for into, columns in (
            (self.coordinates, {row: record.coordinates for row, record in records.items()}),
            (self.values, {row: record.values for row, record in records.items()}),
        ):
            names = dict.fromkeys(name for drawn in columns.values() for name in drawn)
            for name in [name for name in names if name not in into]:
                found = {row: drawn[name] for row, drawn in columns.items() if name in drawn}
                into[name] = _column(found, count)
                if len(found) < count:
                    absent = np.ones(count, bool)
                    absent[list(found)] = False
                    self.absent[name] = absent

    def rows(self, columns: Mapping[str, Sequence[T]], count: int) -> list[dict[str, T]]:
        """Lists (V,) by name as a map for each candidate, without what it has not drawn."""
        names = tuple(columns)
        if not names:
            return [{} for _ in range(count)]
        found = [dict(zip(names, row, strict=True)) for row in zip(*columns.values(), strict=True)]
        for name in self.absent.keys() & columns.keys():
            for row in np.flatnonzero(np.broadcast_to(self.absent[name], (count,))).tolist():
                del found[row][name]
        return found

    def coordinates_of_rows(self, count: int) -> list[dict[str, float]]:
        """The coordinates of each candidate by name."""
        columns: dict[str, list[float]] = {}
        for name, values in self.coordinates.items():
            numbers = values.tolist()
            columns[name] = numbers if len(numbers) == count else numbers * count
        return self.rows(columns, count)


def _column(found: Mapping[int, Any], count: int) -> NDArray[Any]:
    """What was drawn at some rows, each in an array of one row, as one array."""
    first = next(iter(found.values()))
    kind = object if first.dtype.kind == "U" else first.dtype
    column = np.zeros((count, *first.shape[1:]), kind)
    for row, values in found.items():
        column[row] = values.tolist()[0] if kind is object else values[0]
    return column
