"""Candidates of a scenario, many at once, with all that was computed of them so far."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..ir.batch import BatchRandom, RoadBatch, unit_interval
from .randomness import place_keys, variant_keys

if TYPE_CHECKING:
    from .indexed_scenario import IndexedScenario

Floats = NDArray[np.float64]
T = TypeVar("T")


class CandidateBatch:
    """V candidates, told apart by (scene, attempt).

    `given` holds coordinates that a sampler or a search has chosen, (V,) by name; all others are
    hashed of their place. Whatever is computed is kept by `once`, also for the survivors that
    `take` chooses, so that a later requirement pays only for what is new to it.
    """

    def __init__(
        self,
        scenario: IndexedScenario,
        seed: int,
        scenes: NDArray[np.int64],
        attempts: NDArray[np.int64],
        given: Mapping[str, Floats] | None = None,
    ) -> None:
        self.scenario = scenario
        self.seed = seed
        self.scenes = scenes
        self.attempts = attempts
        self.given = given or {}
        self.keys = variant_keys(seed, scenes, attempts)
        self.asked: dict[str, Floats] | None = None
        """All coordinates asked for, (V,) by name, where someone wants to know."""
        self._kept: dict[Hashable, Any] = {}
        self._parent: tuple[CandidateBatch, NDArray[np.intp]] | None = None

    @property
    def count(self) -> int:
        """Number of candidates, V."""
        return len(self.scenes)

    def take(self, rows: NDArray[np.intp]) -> CandidateBatch:
        """The candidates at `rows`."""
        given = {name: values[rows] for name, values in self.given.items()}
        chosen = CandidateBatch(
            self.scenario, self.seed, self.scenes[rows], self.attempts[rows], given
        )
        chosen._parent = (self, rows)
        return chosen

    def once(self, key: Hashable, compute: Callable[[], T]) -> T:
        """What `compute` gives, computed at most once for these candidates."""
        kept: T
        if key in self._kept:
            kept = self._kept[key]
        else:
            found, value = self._inherited(key)
            kept = self._kept[key] = value if found else compute()
        return kept

    def kept(self, group: str) -> list[tuple[Any, Any]]:
        """Keys and values of a group that were computed for these candidates."""
        return [
            (key, value)
            for key, value in self._kept.items()
            if isinstance(key, tuple) and key[0] == group
        ]

    def _inherited(self, key: Hashable) -> tuple[bool, Any]:
        if self._parent is None:
            return False, None
        parent, rows = self._parent
        if key in parent._kept:
            return True, _taken(parent._kept[key], rows, parent.count)
        found, value = parent._inherited(key)
        return found, _taken(value, rows, parent.count) if found else None

    def uniform(self, place: str, element: int = 0) -> Floats:
        """(V, 1) numbers in [0, 1)."""
        name = coordinate_name(place, element)
        if name in self.given:
            numbers = self.given[name][:, None]
        else:
            numbers = unit_interval(place_keys(self.keys, place, element)[:, None], 1)
        if self.asked is not None:
            self.asked[name] = numbers[:, 0]
        return numbers

    def random(self, place: str, element: int = 0) -> BatchRandom:
        """The randomness of a pass."""
        return _PassRandom(self, place, element)


class _PassRandom(BatchRandom):
    """Numbers that a search may choose: coordinate `place:stream:j` is the j-th of a stream."""

    def __init__(self, candidates: CandidateBatch, place: str, element: int) -> None:
        super().__init__(place_keys(candidates.keys, place, element))
        self._candidates = candidates
        self._name = coordinate_name(place, element)

    def uniform(self, count: int, stream: int = 0) -> Floats:
        numbers = super().uniform(count, stream)
        if self._candidates.asked is None and not self._candidates.given:
            return numbers
        for column in range(count):
            name = f"{self._name}:{stream}:{column}"
            if name in self._candidates.given:
                numbers[:, column] = self._candidates.given[name]
            if self._candidates.asked is not None:
                self._candidates.asked[name] = numbers[:, column]
        return numbers


def coordinate_name(place: str, element: int) -> str:
    """`bent/perturb 1/amplitude`; with the number of the road or copy where there are several."""
    return f"{place}[{element}]" if element else place


def _taken(value: Any, rows: NDArray[np.intp], count: int) -> Any:
    """The rows of what was computed for `count` candidates; what is alike in all stays."""
    if isinstance(value, np.ndarray):
        return value if value.ndim == 0 or value.shape[0] == 1 else value[rows]
    if isinstance(value, RoadBatch):
        return value.take(rows)
    if isinstance(value, tuple):
        return tuple(_taken(item, rows, count) for item in value)
    if isinstance(value, dict):
        return {key: _taken(item, rows, count) for key, item in value.items()}
    return value
