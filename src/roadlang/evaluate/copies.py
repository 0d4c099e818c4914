"""The copies of groups in many candidates, a row each, so that all are evaluated at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.batch import unit_interval
from .candidate_rows import rows_of
from .candidates import CandidateBatch
from .draw_names import coordinate_name
from .draw_record import CopyDraws, DrawRecord
from .randomness import place_keys, retried

T = TypeVar("T")


class CopyBatch(CandidateBatch):
    """R copies: the one numbered `copies` (R,), from 1, of the candidate at `rows` (R,).

    A draw of the statement differs by copy, and by `tries` (R,), where a copy is placed again;
    whatever has a name is the same in all copies of a candidate. `evaluate` and `build` are called
    with `element` 1 for a group, with 0 for what has no `count`.
    """

    def __init__(
        self,
        candidates: CandidateBatch,
        rows: NDArray[np.intp],
        copies: Integers,
        tries: Integers | None = None,
    ) -> None:
        scenes, attempts = candidates.scenes[rows], candidates.attempts[rows]
        super().__init__(candidates.scenario, candidates.seed, scenes, attempts)
        self.candidates = candidates
        self._keyed = candidates._keyed
        self.rows = rows
        self.copies = copies
        self.tries = np.zeros(len(rows), np.int64) if tries is None else tries
        self._most = 0
        self._uniform: dict[tuple[str, int], Floats] = {}
        self._drawn: dict[tuple[str, int], Any] = {}

    @classmethod
    def every(
        cls, candidates: CandidateBatch, most: int, tries: Integers | None = None
    ) -> CopyBatch:
        """`most` copies of each candidate, one candidate after the other; `tries` (V, most)."""
        rows = np.repeat(np.arange(candidates.count), most)
        copies = np.tile(np.arange(1, most + 1), candidates.count)
        batch = cls(candidates, rows, copies, None if tries is None else tries.reshape(-1))
        batch._most = most
        return batch

    def of_scene(self, find: Callable[[CandidateBatch], T]) -> T:
        """What `find` gives for the candidates, for each copy."""
        found: T = rows_of(find(self.candidates), self.rows, self.candidates.count)
        return found

    def uniform(self, place: str, element: int = 0) -> Floats:
        """(R, 1) numbers in [0, 1)."""
        numbers = np.zeros(len(self.rows)) if element == 0 else self.copies
        found, chosen = np.empty((len(self.rows), 1)), np.zeros(len(self.rows), bool)
        coordinates = self.candidates.coordinates
        for copy in np.unique(numbers).tolist() if coordinates else ():
            name = coordinate_name(place, int(copy))
            if name in coordinates:
                rows = np.flatnonzero((numbers == copy) & (self.tries == 0))
                found[rows, 0], chosen[rows] = coordinates[name][self.rows[rows]], True
        if not chosen.all():  # whether anything is hashed tells what a candidate depends on
            words = retried(place_keys(self.keys, place, numbers), self.tries)
            found[~chosen] = unit_interval(words[:, None], 1)[~chosen]
        self._uniform[place, element] = found
        return found

    def note_draw(self, place: str, element: int, values: Any) -> None:
        """Remember what was drawn, for `record_in`."""
        self._drawn[place, element] = values

    def chosen(self, index: NDArray[np.intp]) -> CopyBatch:
        """Some of the copies."""
        return CopyBatch(self.candidates, self.rows[index], self.copies[index], self.tries[index])

    def numbered(self, copies: Integers) -> CopyBatch:
        """Other copies (R,) of the same candidates and tries."""
        return CopyBatch(self.candidates, self.rows, copies, self.tries)

    def at_tries(self, tries: Integers) -> CopyBatch:
        """The same copies, placed at other tries (R,)."""
        return CopyBatch(self.candidates, self.rows, self.copies, tries)

    def record_in(self, record: DrawRecord, present: Booleans | None = None) -> None:
        """Add all that was drawn for each copy of each candidate to a record. `present` (R,): the
        copies that their candidates have, if not all."""
        for into, drawn in ((record.coordinates, self._uniform), (record.values, self._drawn)):
            for (place, element), values in drawn.items():
                if element:
                    record.add_copies(into, self._table(place, values[:, 0], present))
                    continue
                column, absent = self._column(values, present)
                column = column[:, 0] if drawn is self._uniform else column
                record.add_shared(into, place, column, absent)

    def _table(self, place: str, values: NDArray[Any], present: Booleans | None) -> CopyDraws:
        """What was drawn for each of the copies (R,)."""
        count = self.candidates.count
        absent = None if present is None or present.all() else ~present
        if self._most:
            shape = count, self._most
            copies = tuple(range(1, self._most + 1))
            missing = None if absent is None else absent.reshape(shape)
            return CopyDraws(place, copies, values.reshape(shape), missing)
        numbers, columns = np.unique(self.copies, return_inverse=True)
        table = np.zeros((count, len(numbers)), values.dtype)
        table[self.rows, columns] = values
        lacking = np.ones(table.shape, bool)
        lacking[self.rows, columns] = False if absent is None else absent
        return CopyDraws(place, tuple(numbers.tolist()), table, lacking if lacking.any() else None)

    def _column(
        self, values: NDArray[Any], present: Booleans | None
    ) -> tuple[NDArray[Any], Booleans]:
        """What was drawn once for all copies (R, 1) of a candidate: (V, 1), and (V,) which
        candidates have no copy."""
        column = np.zeros((self.candidates.count, 1), values.dtype)
        column[self.rows] = values
        absent = np.ones(len(column), bool)
        absent[self.rows if present is None else self.rows[present]] = False
        return column, absent
