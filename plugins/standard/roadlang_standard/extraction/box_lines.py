"""Lines that are boxes rather than roads: frames, tables, charts, diagrams, walls of floor plans.

They are thin, straight and turn by right angles on the spot. A road has a radius.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from .found_network import FoundRoad

_THIN, _HAIR = 0.025, 0.01
"""Boxes are drawn with lines thinner than the first share of the picture's shorter side; a single
corner counts where they are thinner than the second one, ..."""
_BOX, _UPRIGHT = 4, 0.95
"""so many corners are a box; with fewer, this share of the length is upright or level."""
_LEVEL = 0.03
"""Sine of the angle to the picture's sides of what is upright or level."""
_TURN, _LEG, _LEAST_LEG = 3.0, 2.0, 12.0
"""A corner turns within a width and so many pixels to each side, and goes on straight for so many
widths, and so many pixels at least, ..."""
_SQUARE, _STRAIGHT = 0.2, 0.995
"""with less cosine between both, each as straight as this: chord over length."""


def are_boxes(roads: Sequence[FoundRoad], side: float) -> bool:
    """Whether roads that hang together are lines of boxes in a picture of this shorter side."""
    width = float(np.median([np.median(road.widths) for road in roads]))
    if width > _THIN * side:
        return False
    corners = sum(_corners(road) for road in roads)
    if corners >= _BOX:
        return True
    return corners > 0 and width < _HAIR * side and _upright_share(roads) > _UPRIGHT


def _upright_share(roads: Sequence[FoundRoad]) -> float:
    """The share of the length that runs along the rows or the columns of the picture."""
    steps = np.concatenate([np.diff(road.points, axis=0) for road in roads])
    lengths = np.hypot(*steps.T)
    upright = np.abs(steps).min(axis=1) < _LEVEL * lengths
    return float(lengths[upright].sum() / max(float(lengths.sum()), 1e-9))


def _corners(road: FoundRoad) -> int:
    """How many times a road turns on the spot by a right angle, straight before and after it."""
    points = road.points
    step = road.length / max(1, len(points) - 1)
    width = float(np.median(road.widths))
    near = max(1, round((width + _TURN) / max(step, 1e-9)))
    leg = max(1, round(max(_LEG * width, _LEAST_LEG) / max(step, 1e-9)))
    if road.closed:
        points = np.concatenate([points[:-1], points[: 2 * (near + leg) + 1]])
    if len(points) <= 2 * (near + leg):
        return 0
    before, after = _legs(points, near, leg)
    long = [np.hypot(*way.T) for way in (before, after)]
    straight = np.minimum(*long) > _STRAIGHT * leg * step
    cosine = (before * after).sum(axis=1) / np.maximum(long[0] * long[1], 1e-9)
    return _runs(straight & (np.abs(cosine) < _SQUARE))


def _legs(points: Floats, near: int, leg: int) -> tuple[Floats, Floats]:
    """The ways before and after each point that has both, so many points from it and long."""
    middle = np.arange(near + leg, len(points) - near - leg)
    before = points[middle - near] - points[middle - near - leg]
    return before, points[middle + near + leg] - points[middle + near]


def _runs(flags: NDArray[np.bool_]) -> int:
    return int(np.count_nonzero(np.diff(flags.view(np.int8), prepend=0) > 0))
