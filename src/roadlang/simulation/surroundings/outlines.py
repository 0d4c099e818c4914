"""Oriented rectangles that agents and objects cover on the ground, as columns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Floats
from ...ir.scene import SceneActor
from ..state.world import World
from ..vehicles.poses import Poses


@dataclass(frozen=True)
class Outlines:
    """Columns (N,): center, cosine and sine of the heading, half of length and width."""

    x: Floats
    y: Floats
    cosine: Floats
    sine: Floats
    half_length: Floats
    half_width: Floats

    @classmethod
    def of(cls, actors: Sequence[SceneActor]) -> Outlines:
        """What stands still."""
        rows = [(a.x, a.y, a.heading, a.length, a.width) for a in actors]
        x, y, heading, length, width = np.array(rows, dtype=np.float64).reshape(-1, 5).T
        return cls(x, y, np.cos(heading), np.sin(heading), 0.5 * length, 0.5 * width)

    @classmethod
    def moving(cls, world: World, poses: Poses) -> Outlines:
        """The agents of a world."""
        bodies, heading = world.bodies, poses.heading
        return cls(
            poses.x, poses.y, np.cos(heading), np.sin(heading),
            0.5 * bodies.length, 0.5 * bodies.width,
        )  # fmt: skip

    @property
    def columns(self) -> tuple[Floats, ...]:
        """All of them, in their order."""
        return self.x, self.y, self.cosine, self.sine, self.half_length, self.half_width

    def take(self, rows: Any) -> Outlines:
        """Some of them."""
        return Outlines(*(column[rows] for column in self.columns))

    def pieces(self, longest: float) -> Outlines:
        """Each cut across into pieces of the same length, at most `longest` meters."""
        count = np.maximum(np.ceil(2.0 * self.half_length / longest - 1e-9), 1.0).astype(np.int64)
        whole = self.take(np.repeat(np.arange(len(count)), count))
        number = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        half = whole.half_length / count.repeat(count)
        ahead = (2.0 * number + 1.0) * half - whole.half_length
        x, y = whole.x + whole.cosine * ahead, whole.y + whole.sine * ahead
        return Outlines(x, y, whole.cosine, whole.sine, half, whole.half_width)
