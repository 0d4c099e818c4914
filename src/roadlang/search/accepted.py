"""What a search found: the accepted candidates and what was made of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import CandidateBatch
from ..evaluate.draw_record import DrawRecord
from ..evaluate.indexed_scenario import IndexedScenario
from .diversity import expected_nearest, mean_nearest
from .rejection_report import RejectionStats

T = TypeVar("T")
Concretize = Callable[[CandidateBatch, int], T]
"""From the one accepted candidate, which has a record, and the number of its scene to the scene."""


@dataclass(frozen=True)
class Accepted:
    """A candidate that satisfies every requirement: all that is needed to evaluate it again.

    `index` is the number of the scene that it becomes; `coordinates` are those that a sampler
    chose, (1,) by name.
    """

    index: int
    scene: int
    attempt: int
    coordinates: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)

    def candidate(self, scenario: IndexedScenario, seed: int, record: DrawRecord) -> CandidateBatch:
        """The candidate alone: nothing about it depends on the batch that it was found in."""
        scene, attempt = np.array([self.scene]), np.array([self.attempt])
        return CandidateBatch(scenario, seed, scene, attempt, self.coordinates, record)


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
