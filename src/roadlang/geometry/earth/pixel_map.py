"""Pixels of one picture in those of another that shows the same."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..arrays import Floats


@dataclass(frozen=True, slots=True)
class PixelMap:
    """The affine map from pixels of a picture to those of another of `width` x `height` pixels.

    x = m[0] column + m[1] row + m[2] and y = m[3] column + m[4] row + m[5]; (0, 0) is the middle of
    the upper left pixel of either.
    """

    matrix: tuple[float, float, float, float, float, float]
    width: int
    height: int

    def apply(self, points: Floats) -> Floats:
        """Points (..., 2) of the first picture in the other."""
        turn, shift = self._parts
        return np.asarray(np.asarray(points, dtype=float) @ turn.T + shift)

    def undo(self, points: Floats) -> Floats:
        """Points (..., 2) of the other picture in the first."""
        turn, shift = self._parts
        return np.asarray((np.asarray(points, dtype=float) - shift) @ np.linalg.inv(turn).T)

    @property
    def factor(self) -> float:
        """Pixels of the other along a pixel of the first: the root of the ratio of their areas."""
        return math.sqrt(abs(float(np.linalg.det(self._parts[0]))))

    @property
    def turn(self) -> float:
        """How far to the left a line to the right in the first goes in the other, radians."""
        return math.atan2(-self.matrix[3], self.matrix[0])

    @property
    def _parts(self) -> tuple[Floats, Floats]:
        whole = np.array(self.matrix).reshape(2, 3)
        return whole[:, :2], whole[:, 2]
