"""What was drawn while candidates were evaluated."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain, compress
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..geometry.arrays import Booleans
from .candidate_rows import rows_of
from .draw_names import coordinate_names

T = TypeVar("T")


@dataclass(frozen=True, eq=False)
class CopyDraws:
    """What was drawn at one place for the N copies of a group in V candidates: a table (V, N), and
    which of it some candidates do not have, if any."""

    place: str
    copies: tuple[int, ...]
    """(N,) their numbers, from 1"""
    table: NDArray[Any]
    absent: Booleans | None = None
    """(V, N)"""

    @property
    def names(self) -> tuple[str, ...]:
        """(N,) as `tree/at[2]`."""
        return coordinate_names(self.place, self.copies)

    def take(self, rows: NDArray[np.intp]) -> CopyDraws | None:
        """Those of the candidates at `rows`; None where they have none."""
        if self.absent is None:
            return CopyDraws(self.place, self.copies, self.table[rows])
        absent = self.absent[rows]
        has = np.flatnonzero(~absent.all(axis=0))
        if not len(has):
            return None
        copies = tuple([self.copies[column] for column in has.tolist()])
        some = absent[:, has] if absent[:, has].any() else None
        return CopyDraws(self.place, copies, self.table[np.ix_(rows, has)], some)

    def joined(self, later: CopyDraws) -> CopyDraws:
        """These and later ones: copies of different kinds draw their options at the same place."""
        copies = tuple(sorted({*self.copies, *later.copies}))
        table = np.zeros((len(self.table), len(copies)), np.result_type(self.table, later.table))
        absent = np.ones(table.shape, bool)
        for part in (self, later):
            columns = np.searchsorted(copies, part.copies)
            lacks = np.zeros(part.table.shape, bool) if part.absent is None else part.absent
            table[:, columns] = np.where(lacks, table[:, columns], part.table)
            absent[:, columns] &= lacks
        return CopyDraws(self.place, copies, table, absent if absent.any() else None)


@dataclass(frozen=True)
class DrawRecord:
    """Filled by the `CandidateBatch` that it is passed to, in the order in which it draws.

    Names are places of draws, with the number of the road or copy where there are several:
    `bent/perturb 1/amplitude`, `tree/at[2]`. What copies draw is kept by its place, of all of them
    together.
    """

    coordinates: dict[str, NDArray[np.float64] | CopyDraws] = field(default_factory=dict)
    """(V,) numbers in [0, 1) that draws and passes were made from"""
    values: dict[str, Any] = field(default_factory=dict)
    """(V, 1) what was drawn"""
    absent: dict[str, NDArray[np.bool_]] = field(default_factory=dict)
    """(V,) candidates that do not have a draw: those of copies that only others have"""

    def add_copies(self, into: dict[str, Any], drawn: CopyDraws) -> None:
        """Add what copies drew to `coordinates` or `values`, beside what others drew there."""
        known = into.get(drawn.place)
        into[drawn.place] = drawn if known is None else known.joined(drawn)

    def add_shared(
        self, into: dict[str, Any], place: str, column: NDArray[Any], lacking: Booleans
    ) -> None:
        """Add what one draw of a place gave (V,) or (V, 1) to `coordinates` or `values`, but for
        candidates that lack it (V,), beside what those drew there for another kind."""
        if place in into:
            shape = lacking.reshape(lacking.shape + (1,) * (column.ndim - 1))
            column = np.where(shape, into[place], column)
            lacking = lacking & self.absent.pop(place, np.zeros(len(lacking), bool))
        into[place] = column
        if lacking.any():
            self.absent[place] = lacking

    def named_coordinates(self) -> dict[str, NDArray[np.float64]]:
        """The coordinates (V,) by name, also those of copies."""
        return dict(_named(self.coordinates))

    def take(self, rows: NDArray[np.intp], count: int) -> DrawRecord:
        """What the candidates at `rows` of `count` have drawn."""
        absent = {name: rows_of(value, rows, count) for name, value in self.absent.items()}
        missing = {name for name, value in absent.items() if value.all()}
        coordinates, values = (
            {
                name: taken
                for name, value in found.items()
                if name not in missing
                and (
                    taken := value.take(rows)
                    if isinstance(value, CopyDraws)
                    else rows_of(value, rows, count)
                )
                is not None
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
            (self.coordinates, {row: dict(_named(r.coordinates)) for row, r in records.items()}),
            (self.values, {row: dict(_named(r.values)) for row, r in records.items()}),
        ):
            names = dict.fromkeys(name for drawn in columns.values() for name in drawn)
            known = {name for name, _ in _named(into)} if names else set()
            for name in [name for name in names if name not in known]:
                found = {row: drawn[name] for row, drawn in columns.items() if name in drawn}
                into[name] = _column(found, count)
                if len(found) < count:
                    absent = np.ones(count, bool)
                    absent[list(found)] = False
                    self.absent[name] = absent

    def coordinates_of_rows(self, count: int) -> list[dict[str, float]]:
        """The coordinates of each candidate by name."""
        return self._rows(self.coordinates, count, lambda column: column.reshape(-1).tolist())

    def values_of_rows(self, count: int, plain: Callable[[Any], Sequence[T]]) -> list[dict[str, T]]:
        """What each candidate has drawn, by name in order. `plain` makes a list of a column (V, 1)
        or of a table (V, N), candidate by candidate."""
        return self._rows(dict(sorted(self.values.items())), count, plain, ordered=True)

    def _rows(
        self,
        columns: Mapping[str, Any],
        count: int,
        plain: Callable[[Any], Sequence[T]],
        ordered: bool = False,
    ) -> list[dict[str, T]]:
        """Columns by name as a map for each candidate, without what it has not drawn."""
        single = {name: column for name, column in columns.items() if type(column) is not CopyDraws}
        copies = [column for column in columns.values() if type(column) is CopyDraws]
        names = [*single, *chain.from_iterable(column.names for column in copies)]
        lists = [plain(column) for column in single.values()]
        lists = [items if len(items) == count else [*items] * count for items in lists]
        heads: Iterable[tuple[T, ...]] = zip(*lists, strict=True) if lists else [()] * count
        tables = [(plain(column.table), len(column.copies)) for column in copies]
        rows = [
            [*head, *chain.from_iterable(t[row * n : (row + 1) * n] for t, n in tables)]
            for row, head in enumerate(heads)
        ]
        order = sorted(range(len(names)), key=names.__getitem__) if ordered and copies else None
        if order is not None:
            names = [names[index] for index in order]
            rows = [[row[index] for index in order] for row in rows]
        absent = self._absent(single, copies, count)
        if absent is None:
            return [dict(zip(names, row, strict=True)) for row in rows]
        has = ~(absent if order is None else absent[:, order])
        return [
            dict(zip(compress(names, mask), compress(row, mask), strict=True))
            for row, mask in zip(rows, has.tolist(), strict=True)
        ]

    def _absent(
        self, single: Iterable[str], copies: Sequence[CopyDraws], count: int
    ) -> Booleans | None:
        """(V, names) which of these draws candidates lack; None where they have all."""
        single = list(single)
        some = self.absent.keys() & set(single) or any(c.absent is not None for c in copies)
        if not some:
            return None
        no = np.zeros(count, bool)
        parts = [np.broadcast_to(self.absent.get(name, no), (count,))[:, None] for name in single]
        none = (np.zeros(c.table.shape, bool) if c.absent is None else c.absent for c in copies)
        return np.concatenate([*parts, *none], axis=1)


def _named(columns: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Columns by name, a table of copies as one for each copy."""
    for name, column in columns.items():
        if isinstance(column, CopyDraws):
            yield from zip(column.names, column.table.T, strict=True)
        else:
            yield name, column


def _column(found: Mapping[int, Any], count: int) -> NDArray[Any]:
    """What was drawn at some rows, each in an array of one row, as one array."""
    first = next(iter(found.values()))
    kind = object if first.dtype.kind == "U" else first.dtype
    column = np.zeros((count, *first.shape[1:]), kind)
    for row, values in found.items():
        column[row] = values.tolist()[0] if kind is object else values[0]
    return column
