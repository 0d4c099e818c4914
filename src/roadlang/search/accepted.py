"""What a search found: the accepted candidates and what was made of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.draw_record import DrawRecord
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Integers
from ..judging.acceptance import AcceptanceResult
from .diversity import expected_nearest, mean_nearest
from .rejection_report import RejectionStats

T = TypeVar("T")
Concretize = Callable[[CandidateBatch, Sequence[int]], list[T]]
"""From accepted candidates, which have a record, and the numbers of their scenes to the scenes.
Raises DiagnosticError where that cannot be done of all together, or of one."""


@dataclass(frozen=True)
class Accepted:
    """A candidate that satisfies every requirement: all that is needed to evaluate it again.

    `index` is the number of the scene that it becomes; `coordinates` are those that a sampler
    chose, (1,) by name. `tries`: (N,) by agent or object at which try each copy was placed.
    """

    index: int
    scene: int
    attempt: int
    coordinates: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    tries: Mapping[str, Integers] = field(default_factory=dict)

    @classmethod
    def of(
        cls, candidates: CandidateBatch, judged: AcceptanceResult, row: int, index: int
    ) -> Accepted:
        """The candidate at `row`, which becomes the scene of that number."""
        chosen = {name: values[row : row + 1] for name, values in candidates.coordinates.items()}
        scene, attempt = int(candidates.scenes[row]), int(candidates.attempts[row])
        return cls(index, scene, attempt, chosen, judged.tries_of(row))


def candidates_of(
    accepted: Sequence[Accepted], scenario: IndexedScenario, seed: int
) -> CandidateBatch:
    """Accepted candidates with a record, of which a sampler chose the same coordinates: nothing
    about one depends on the others."""
    names = accepted[0].coordinates
    return CandidateBatch(
        scenario,
        seed,
        np.array([each.scene for each in accepted]),
        np.array([each.attempt for each in accepted]),
        {name: np.concatenate([each.coordinates[name] for each in accepted]) for name in names},
        DrawRecord(),
        _tries_of(accepted),
    )


def _tries_of(accepted: Sequence[Accepted]) -> dict[str, Integers]:
    """(V, N) by agent or object that was placed in all."""
    tries = {}
    for name in set.intersection(*(set(each.tries) for each in accepted)):
        rows = [each.tries[name] for each in accepted]
        table = np.zeros((len(rows), max(len(row) for row in rows)), np.int64)
        for into, row in zip(table, rows, strict=True):
            into[: len(row)] = row
        tries[name] = table
    return tries


@dataclass(frozen=True)
class Sample(Generic[T]):
    """What an accepted candidate became, and its draws in the unit cube, by name."""

    result: T
    coordinates: Mapping[str, float]


@dataclass(frozen=True)
class SearchedBlock(Generic[T]):
    """The samples of a block of scenes, in order, the scenes that were given up, and the counts."""

    samples: tuple[Sample[T], ...]
    missing: tuple[int, ...]
    stats: RejectionStats


@dataclass
class AcceptedSamples(Generic[T]):
    """What a whole search came to."""

    wanted: int
    stats: RejectionStats
    samples: list[Sample[T]] = field(default_factory=list)
    missing: list[int] = field(default_factory=list)

    @property
    def diversity(self) -> float | None:
        """Mean distance of each sample's draws to the nearest other, in the unit cube."""
        return mean_nearest(self._draws)

    @property
    def expected_diversity(self) -> float | None:
        """The same of as many even draws in a cube as large as the part where candidates hold."""
        share = self.stats.even_share
        if share is None and self.stats.candidates:
            share = len(self.samples) / self.stats.candidates
        return None if share is None else expected_nearest(self._draws, share)

    @property
    def _draws(self) -> list[Mapping[str, float]]:
        return [sample.coordinates for sample in self.samples]
