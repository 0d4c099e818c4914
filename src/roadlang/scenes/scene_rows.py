"""Candidates that become scenes: what is made for all of them at once, and what for each alone."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidate_rows import rows_of
from ..evaluate.candidates import CandidateBatch
from ..evaluate.concrete import concrete
from ..evaluate.draw_record import DrawRecord
from ..ir.read_only import FrozenDict, frozen
from ..ir.values import PassCall, Value

T = TypeVar("T")


class SceneRows:
    """V candidates with a record. Everything that is made of them is a list (V,), an item for each
    scene; scenes in which it is the same have the same object."""

    def __init__(self, candidates: CandidateBatch) -> None:
        assert candidates.record is not None
        self.candidates = candidates
        self.scenario = candidates.scenario
        self.count = candidates.count
        self.record = candidates.record
        self._alone: dict[int, CandidateBatch] = {}

    def alone(self, row: int) -> CandidateBatch:
        """One of the candidates, with a record of what is drawn for it alone."""
        if self.count == 1:
            return self.candidates
        if row not in self._alone:
            single = self.candidates.take(np.array([row]))
            single.record = DrawRecord()
            self._alone[row] = single
        return self._alone[row]

    def each(self, make: Callable[[CandidateBatch], T]) -> list[T]:
        """What can only be made of one candidate at a time."""
        return [make(self.alone(row)) for row in range(self.count)]

    def same(self, value: T) -> list[T]:
        """What all scenes have."""
        return [value] * self.count

    def differ(self, *values: Value | None) -> bool:
        """Whether anything in these values is drawn, or measured of a scene."""
        return self.scenario.dependencies.differ(*values)

    def plain(self, value: Any) -> list[Any]:
        """Values as a scene has them: plain numbers and words, infinity as a word."""
        if not isinstance(value, np.ndarray | tuple | dict | list):
            return self.same(_plain(value, self.candidates))
        if isinstance(value, np.ndarray) and value.size in (1, self.count):
            items = self._items(value)
            return items if len(items) == self.count else items * self.count
        if self.count == 1:
            return [frozen(_plain(value, self.candidates))]
        return [
            frozen(_plain(rows_of(value, np.array([row]), self.count), self.alone(row)))
            for row in range(self.count)
        ]

    def draws(self) -> list[FrozenDict[str, Any]]:
        """Every random value by its place, of all that was evaluated so far."""
        self._join_records()
        return [*map(FrozenDict, self.record.values_of_rows(self.count, self._items))]

    def _items(self, column: NDArray[Any]) -> list[Any]:
        """Each value of an array as a scene has it."""
        items: list[Any] = column.reshape(-1).tolist()
        if _are_plain(items):
            return items
        distinct = {id(item): item for item in items}
        shown = {key: frozen(_plain(item, self.candidates)) for key, item in distinct.items()}
        return [shown[id(item)] for item in items]

    def _join_records(self) -> None:
        alone = {row: single.record for row, single in self._alone.items() if single.record}
        self.record.add_alone(alone, self.count)


def _are_plain(items: Sequence[Any]) -> bool:
    """Whether they are words, or numbers that are finite."""
    kinds = set(map(type, items))
    return kinds <= _PLAIN or (kinds == {float} and all(map(math.isfinite, items)))


_PLAIN = frozenset((str, int, bool))


def _plain(value: Any, candidates: CandidateBatch) -> Any:
    """Of a single candidate."""
    if isinstance(value, np.ndarray) and value.dtype == float and value.size == 1:
        number: float = value.item()
        if math.isfinite(number):
            return number
    if isinstance(value, PassCall):
        return value.kind.rpartition(".")[2]
    if isinstance(value, np.ndarray) and value.dtype == object:
        return _plain(value.reshape(-1)[0], candidates)
    return concrete(value, candidates)
