"""From the world's meters (x east, y north) to the engine's (x east, y up, z south)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roadlang.api import Code

from ..faults import fault
from ..net.protocol import MAX_COORDINATE


@dataclass(frozen=True, slots=True)
class SceneOrigin:
    """The engine's origin in the world, so that float32 is fine enough everywhere in the scene."""

    x: float = 0.0
    y: float = 0.0
    level: float = 0.0
    """meters that what is built in this frame lies above the ground"""

    def ground(self, points: NDArray[np.float64], height: float = 0.0) -> NDArray[np.float32]:
        """(n, 2) world points to (n, 3) engine coordinates, at a height above the ground."""
        local = np.empty((len(points), 3))
        local[:, 0] = points[:, 0] - self.x
        local[:, 1] = self.level + height
        local[:, 2] = self.y - points[:, 1]
        if len(local) and not np.abs(local).max() <= MAX_COORDINATE:
            raise fault(Code.GODOT_ERROR, reason="a scene is at most 200 km wide")
        return local.astype("<f4")


def frame_around(points: NDArray[np.float64]) -> tuple[SceneOrigin, float]:
    """The frame in the middle of (n, 2) points, and how far they reach from it, in meters."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle = np.round((low + high) / 2)
    origin = SceneOrigin(float(middle[0]), float(middle[1]))
    return origin, extent_from(origin, points)


def extent_from(origin: SceneOrigin, points: NDArray[np.float64]) -> float:
    """How far (n, 2) points reach from an origin to any side, in meters."""
    return float(np.abs(points - (origin.x, origin.y)).max())
