"""Candidates of a scenario, many at once, with all that was computed of them so far."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from functools import cached_property
from typing import Any, TypeVar
from weakref import ref

import numpy as np
from numpy.typing import NDArray

from ..geometry.arrays import Floats, Integers
from ..ir.batch import BatchRandom, unit_interval
from ..ir.read_only import frozen
from .candidate_rows import rows_of
from .draw_names import coordinate_name
from .draw_record import DrawRecord
from .indexed_scenario import IndexedScenario
from .randomness import Words, place_keys, variant_keys

T = TypeVar("T")
_Parent = tuple[Callable[[], "CandidateBatch | None"], NDArray[np.intp]]
"""What candidates were taken from, as long as it exists, and at which rows."""


class CandidateBatch:
    """V candidates, identified by (scene, attempt).

    `coordinates` are those that a sampler or a search has chosen, (V,) by name; all others are
    hashed of their place. `record`, where one is passed, collects all draws. Whatever is
    computed is kept by `once`, also for the survivors that `take` chooses, so that a later
    requirement pays only for what is new to it; they have no record. `known_tries`: (V, N) by
    agent or object at which try each copy is to be placed, where a search has found that.
    """

    def __init__(
        self,
        scenario: IndexedScenario,
        seed: int,
        scenes: NDArray[np.int64],
        attempts: NDArray[np.int64],
        coordinates: Mapping[str, Floats] | None = None,
        record: DrawRecord | None = None,
        known_tries: Mapping[str, Integers] | None = None,
    ) -> None:
        self.scenario = scenario
        self.seed = seed
        self.scenes = scenes
        self.attempts = attempts
        self.coordinates = coordinates or {}
        self.record = record
        self.known_tries = known_tries or {}
        self._computed: dict[Hashable, Any] = {}
        self._parent: _Parent | None = None
        self._singles: dict[int, CandidateBatch] = {}
        self._keyed: set[str] = set()  # shared with all that are made of these candidates

    @cached_property
    def keys(self) -> Words:
        """(V,) one word for each candidate, of which its draws are made."""
        self._keyed.add("keys")
        return variant_keys(self.seed, self.scenes, self.attempts)

    @property
    def is_keyed(self) -> bool:
        """Whether anything so far depends on scene and attempt, not on coordinates alone."""
        return bool(self._keyed)

    @property
    def count(self) -> int:
        """Number of candidates, V."""
        return len(self.scenes)

    def take(self, rows: NDArray[np.intp]) -> CandidateBatch:
        """The candidates at `rows`."""
        coordinates = {name: values[rows] for name, values in self.coordinates.items()}
        chosen = CandidateBatch(
            self.scenario, self.seed, self.scenes[rows], self.attempts[rows], coordinates
        )
        chosen.known_tries = {name: tries[rows] for name, tries in self.known_tries.items()}
        chosen._parent, chosen._keyed = (lambda: self, rows), self._keyed
        return chosen

    def single(self, row: int) -> CandidateBatch:
        """The candidate at `row` alone, with a record where these have one.

        It is the same object each time, also that of the batch that these were taken from: what was
        computed of it is kept where candidates cannot be computed together.
        """
        if self.count == 1:
            return self
        if row not in self._singles:
            rows = np.array([row])
            self._singles[row] = self._single_of_parent(rows) or self._first_single(rows)
        return self._singles[row]

    def _first_single(self, rows: NDArray[np.intp]) -> CandidateBatch:
        found = self.take(rows) if self.record is None else self.take_recorded(rows)
        found._parent = ref(self), rows  # it is held by these: all is freed with the last use
        return found

    def _single_of_parent(self, rows: NDArray[np.intp]) -> CandidateBatch | None:
        parent = None if self._parent is None else self._parent[0]()
        if self._parent is None or parent is None:
            return None
        found = parent.single(int(self._parent[1][rows[0]]))
        scenes, attempts = self.scenes[rows], self.attempts[rows]
        if found.scenes[0] == scenes[0] and found.attempts[0] == attempts[0]:
            return found
        alone = np.zeros(1, np.intp)
        return None if found.is_keyed else found.renumbered(alone, scenes, attempts)

    def take_recorded(self, rows: NDArray[np.intp]) -> CandidateBatch:
        """The candidates at `rows`, with a record of their own of what they have drawn so far."""
        assert self.record is not None
        chosen = self.take(rows)
        chosen.record = self.record.take(rows, self.count)
        return chosen

    def renumbered(
        self, rows: NDArray[np.intp], scenes: NDArray[np.int64], attempts: NDArray[np.int64]
    ) -> CandidateBatch:
        """The same as other scenes and attempts, where nothing so far depends on these."""
        assert not self.is_keyed
        chosen = self.take_recorded(rows)
        chosen.scenes, chosen.attempts, chosen._keyed = scenes, attempts, set()
        return chosen

    def once(self, key: Hashable, compute: Callable[[], T], *, inherited: bool = True) -> T:
        """What `compute` gives, computed at most once for these candidates.

        `inherited`: survivors have their rows of it; else it is computed anew for them.
        """
        computed: T
        if key in self._computed:
            computed = self._computed[key]
        elif not inherited:
            computed = self._computed[key] = compute()
        else:
            found, value = self._inherited(key)
            computed = self._computed[key] = value if found else compute()
        return computed

    def root(self, key: Hashable, is_drawn: bool, make: Callable[[CandidateBatch], T]) -> T:
        """What `make` gives for these candidates; where nothing of it is drawn, once for all."""
        if is_drawn:
            return self.once(key, lambda: make(self))
        return self.scenario.once(key, lambda: make(fixed_candidate(self.scenario)))

    def _inherited(self, key: Hashable) -> tuple[bool, Any]:
        parent = None if self._parent is None else self._parent[0]()
        if self._parent is None or parent is None:
            return False, None
        rows = self._parent[1]
        if key in parent._computed:
            return True, rows_of(parent._computed[key], rows, parent.count)
        found, value = parent._inherited(key)
        return found, rows_of(value, rows, parent.count) if found else None

    def uniform(self, place: str, element: int = 0) -> Floats:
        """(V, 1) numbers in [0, 1)."""
        name = coordinate_name(place, element)
        if name in self.coordinates:
            numbers = self.coordinates[name][:, None]
        else:
            numbers = unit_interval(place_keys(self.keys, place, element)[:, None], 1)
        if self.record is not None:
            self.record.coordinates[name] = numbers[:, 0]
        return numbers

    def of_scene(self, find: Callable[[CandidateBatch], T]) -> T:
        """What `find` gives for candidates: a copy has it from its candidate."""
        return find(self)

    def note_draw(self, place: str, element: int, values: Any) -> None:
        """Remember what was drawn, where there is a record."""
        if self.record is not None:
            self.record.values[coordinate_name(place, element)] = values

    def random(self, place: str, element: int = 0) -> BatchRandom:
        """The randomness of a pass."""
        return _PassRandom(self, place, element)


class _PassRandom(BatchRandom):
    """Numbers that a search may choose: coordinate `place:stream:j` is the j-th of a stream."""

    def __init__(self, candidates: CandidateBatch, place: str, element: int) -> None:
        self._candidates = candidates
        self._place = place, element
        self._name = coordinate_name(place, element)

    @cached_property
    def keys(self) -> Words:
        """(V,) one word for each candidate, computed for those kinds alone that look."""
        words: Words = frozen(place_keys(self._candidates.keys, *self._place))
        return words

    @property
    def variants(self) -> int:
        """That of the candidates."""
        return self._candidates.count

    def uniform(self, count: int, stream: int = 0) -> Floats:
        record, coordinates = self._candidates.record, self._candidates.coordinates
        names = [f"{self._name}:{stream}:{column}" for column in range(count)]
        is_chosen = bool(names) and coordinates.keys() >= set(names)
        shape = self._candidates.count, count
        numbers = np.empty(shape) if is_chosen else super().uniform(count, stream)
        if record is None and not coordinates:
            return numbers
        for column, name in enumerate(names):
            if name in coordinates:
                numbers[:, column] = coordinates[name]
            if record is not None:
                record.coordinates[name] = numbers[:, column]
        return numbers


def fixed_candidate(scenario: IndexedScenario) -> CandidateBatch:
    """The one candidate that what does not depend on any draw is computed for."""
    first = np.zeros(1, np.int64)
    return scenario.once("fixed candidate", lambda: CandidateBatch(scenario, 0, first, first))
