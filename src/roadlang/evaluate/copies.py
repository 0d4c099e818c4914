"""The copies of groups in many candidates, a row each, so that all are evaluated at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.batch import unit_interval
from .candidate_rows import rows_of
from .candidates import CandidateBatch, coordinate_name
from .draw_record import DrawRecord
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
        self._uniform: dict[tuple[str, int], Floats] = {}
        self._drawn: dict[tuple[str, int], Any] = {}

    @classmethod
    def every(
        cls, candidates: CandidateBatch, most: int, tries: Integers | None = None
    ) -> CopyBatch:
        """`most` copies of each candidate, one candidate after the other; `tries` (V, most)."""
        rows = np.repeat(np.arange(candidates.count), most)
        copies = np.tile(np.arange(1, most + 1), candidates.count)
        return cls(candidates, rows, copies, None if tries is None else tries.reshape(-1))

    def of_scene(self, find: Callable[[CandidateBatch], T]) -> T:
        """What `find` gives for the candidates, for each copy."""
        found: T = rows_of(find(self.candidates), self.rows, self.candidates.count)
        return found

    def uniform(self, place: str, element: int = 0) -> Floats:
        """(R, 1) numbers in [0, 1)."""
        numbers = np.zeros(len(self.rows)) if element == 0 else self.copies
        words = retried(place_keys(self.keys, place, numbers), self.tries)
        found = unit_interval(words[:, None], 1)
        coordinates = self.candidates.coordinates
        for copy in np.unique(numbers).tolist() if coordinates else ():
            name = coordinate_name(place, int(copy))
            if name in coordinates:
                chosen = (numbers == copy) & (self.tries == 0)
                found[chosen, 0] = coordinates[name][self.rows[chosen]]
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
        order = np.argsort(self.copies, kind="stable")
        copies, first = np.unique(self.copies[order], return_index=True)
        ends = [*first[1:].tolist(), len(order)]
        parts = list(zip(copies.tolist(), first.tolist(), ends, strict=True))
        absent = None if present is None or present.all() else ~present[order]
        for (place, element), values in self._uniform.items():
            numbers = values[order, 0]
            for copy, start, stop in parts:
                name = coordinate_name(place, element * copy)
                record.coordinates[name] = numbers[start:stop]
                if absent is not None and element:
                    record.absent[name] = absent[start:stop]
        for (place, element), values in self._drawn.items():
            drawn = values[order]
            for copy, start, stop in parts:
                name = coordinate_name(place, element * copy)
                record.values[name] = drawn[start:stop]
                if absent is not None and element:
                    record.absent[name] = absent[start:stop]
