"""The episodes of the environments of a vector, one after the other for each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Protocol

import numpy as np

from ..geometry.arrays import Floats, Integers
from .episodes import EpisodeEnds, Episodes, can_restart
from .observed import Observed, joined
from .rewards import Transition
from .scene_pool import ScenePool
from .settings import EnvSettings


class Rows(Protocol):
    """N environments. `scenes`: (N,) the number of the scene in which each is."""

    @property
    def scenes(self) -> Integers: ...  # noqa: D102 - said above

    def observe(self) -> Observed:
        """(N, F) what all see."""
        ...

    def step(self, actions: Floats) -> tuple[Transition, EpisodeEnds]:
        """Drive on, with actions (N, 2)."""
        ...

    def advance(self, rows: Integers) -> None:
        """Some begin their next episode."""
        ...


def rows_of(pool: ScenePool, draws: Sequence[Sequence[int]], settings: EnvSettings) -> Rows:
    """`draws`: the scenes of each environment, by their places in the pool, in their order."""
    kind = Together if can_restart(pool) else OneByOne
    return kind(pool, draws, settings)


class Together:
    """All in one batch. Those scenes of an environment in which it is not go on unseen."""

    def __init__(
        self, pool: ScenePool, draws: Sequence[Sequence[int]], settings: EnvSettings
    ) -> None:
        self._each = len(draws[0])
        self._episodes = Episodes(pool, [scene for each in draws for scene in each], settings)
        self._first = np.arange(len(draws)) * self._each
        self._turn = np.zeros(len(draws), dtype=np.int64)
        self._index = np.array([[pool.scenes[scene].index for scene in each] for each in draws])

    @property
    def scenes(self) -> Integers:
        """(N,) numbers of scenes."""
        return np.asarray(self._index[np.arange(len(self._turn)), self._turn])

    def observe(self) -> Observed:
        """(N, F)."""
        return self._episodes.observe(self._first + self._turn)

    def step(self, actions: Floats) -> tuple[Transition, EpisodeEnds]:
        """Drive on."""
        return self._episodes.step(self._first + self._turn, actions)

    def advance(self, rows: Integers) -> None:
        """Some begin their next episode."""
        self._turn[rows] = (self._turn[rows] + 1) % self._each
        self._episodes.restart((self._first + self._turn)[rows])


class OneByOne:
    """Each in an engine of its own."""

    def __init__(
        self, pool: ScenePool, draws: Sequence[Sequence[int]], settings: EnvSettings
    ) -> None:
        self._pool, self._draws, self._settings = pool, draws, settings
        self._turn = np.zeros(len(draws), dtype=np.int64)
        self._episodes = [Episodes(pool, [each[0]], settings) for each in draws]

    @property
    def scenes(self) -> Integers:
        """(N,) numbers of scenes."""
        turns = zip(self._draws, self._turn.tolist(), strict=True)
        return np.array([self._pool.scenes[each[turn]].index for each, turn in turns])

    def observe(self) -> Observed:
        """(N, F)."""
        return joined([episode.observe(_ONLY) for episode in self._episodes])

    def step(self, actions: Floats) -> tuple[Transition, EpisodeEnds]:
        """Drive on."""
        found = [episode.step(_ONLY, actions[[i]]) for i, episode in enumerate(self._episodes)]
        happened = [transition for transition, _ in found]
        columns = {
            field.name: np.concatenate([getattr(step, field.name) for step in happened])
            for field in fields(Transition)
            if field.name != "margins"
        }
        margins = {
            name: np.concatenate([step.margins[name] for step in happened])
            for name in happened[0].margins
        }
        ends = EpisodeEnds(
            *(
                np.concatenate([getattr(step, field.name) for _, step in found])
                for field in fields(EpisodeEnds)
            )
        )
        return Transition(margins=margins, **columns), ends

    def advance(self, rows: Integers) -> None:
        """Some begin their next episode."""
        for row in rows:
            each = self._draws[row]
            self._turn[row] = (self._turn[row] + 1) % len(each)
            self._episodes[row] = Episodes(self._pool, [each[self._turn[row]]], self._settings)


_ONLY = np.zeros(1, dtype=np.int64)
