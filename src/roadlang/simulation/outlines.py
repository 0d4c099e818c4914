"""Oriented rectangles that agents and objects cover on the ground, as columns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from ..geometry.arrays import Floats
from ..ir.scene import SceneActor
from .poses import Poses
from .world import World


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

    def take(self, rows: Any) -> Outlines:
        """Some of them."""
        return Outlines(*(getattr(self, field.name)[rows] for field in fields(self)))

    def joined(self, other: Outlines) -> Outlines:
        """These, then others."""
        return Outlines(
            *(
                np.concatenate([getattr(self, field.name), getattr(other, field.name)])
                for field in fields(self)
            )
        )

    def distances(self, other: Outlines) -> Floats:
        """(N,) meters between the centers, one by one."""
        return np.hypot(self.x - other.x, self.y - other.y)


def gaps(a: Outlines, b: Outlines) -> Floats:
    """(N,) meters of free space between rectangles, one by one; 0 where they overlap."""
    to_b, apart_b = _outside(a, b)
    to_a, apart_a = _outside(b, a)
    return np.where(apart_a | apart_b, np.minimum(to_a, to_b), 0.0)


def _outside(a: Outlines, b: Outlines) -> tuple[Floats, Any]:
    """Distance of the nearest corner of `a` from `b`; whether the axes of `b` separate them."""
    along, across = [], []
    for i, j in ((1, 1), (1, -1), (-1, -1), (-1, 1)):
        x = a.x + i * a.half_length * a.cosine - j * a.half_width * a.sine - b.x
        y = a.y + i * a.half_length * a.sine + j * a.half_width * a.cosine - b.y
        along.append(x * b.cosine + y * b.sine)
        across.append(y * b.cosine - x * b.sine)
    by_corner = [
        np.hypot(
            np.maximum(np.abs(p) - b.half_length, 0.0), np.maximum(np.abs(q) - b.half_width, 0.0)
        )
        for p, q in zip(along, across, strict=True)
    ]
    p, q = np.array(along), np.array(across)
    apart = (
        (p.min(axis=0) > b.half_length)
        | (p.max(axis=0) < -b.half_length)
        | (q.min(axis=0) > b.half_width)
        | (q.max(axis=0) < -b.half_width)
    )
    return np.min(by_corner, axis=0), apart
