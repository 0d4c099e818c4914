"""Lines that are boxes rather than roads: frames, tables, charts, diagrams, walls of floor plans.

They are thin, straight and turn by right angles on the spot. A road has a radius.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from ..networks.found_network import FoundRoad

_THIN, _HAIR = 0.025, 0.01
"""Boxes are drawn with lines thinner than `_THIN` of the picture's shorter side. Where lines are
thinner than `_HAIR`, a single corner counts."""
_BOX, _UPRIGHT = 4, 0.95
"""Lines with `_BOX` right-angled corners are a box; with fewer, if at least `_UPRIGHT` of their
length is horizontal or vertical."""
_LEVEL = 0.03
"""Lines are horizontal or vertical if the sine of their angle to the sides of the picture is
smaller."""
_TURN, _LEG, _LEAST_LEG = 3.0, 2.0, 12.0
"""A corner turns within one width and `_TURN` pixels to each side; its two legs are straight for
`_LEG` widths, and for `_LEAST_LEG` pixels at least."""
_SQUARE, _STRAIGHT = 0.2, 0.995
"""The cosine between the two legs of a corner is below `_SQUARE`, and the chord of each is at least
`_STRAIGHT` of its length."""


def are_boxes(roads: Sequence[FoundRoad], side: float) -> bool:
    """Whether roads that hang together are lines of boxes in a picture of this shorter side."""
    widths = np.array([road.usual_width for road in roads])
    width = float(np.median(widths))
    if width > _THIN * side:
        return False
    corners = _corners(roads, widths)
    if corners >= _BOX:
        return True
    return corners > 0 and width < _HAIR * side and upright_share(roads) > _UPRIGHT


def are_framed(
    roads: Sequence[FoundRoad], frames: Sequence[Sequence[FoundRoad]], side: float
) -> bool:
    """Whether roads that hang together are hair lines within a frame, or the axes, of hair lines:
    curves of a chart. A frame near the border of the picture has been left out before."""
    if not _are_hair(roads, side):
        return False
    low, high = _bounds(roads)
    for frame in frames:
        least, most = _bounds(frame)
        if _are_hair(frame, side) and (low >= least - 1).all() and (high <= most + 1).all():
            return True
    return False


def _are_hair(roads: Sequence[FoundRoad], side: float) -> bool:
    return float(np.median([road.usual_width for road in roads])) < _HAIR * side


def _bounds(roads: Sequence[FoundRoad]) -> tuple[Floats, Floats]:
    """The least and the greatest coordinates (2,) of some roads."""
    points = np.concatenate([road.points for road in roads])
    return points.min(axis=0), points.max(axis=0)


def upright_share(roads: Sequence[FoundRoad]) -> float:
    """The share of the length that runs along the rows or the columns of the picture."""
    steps = np.concatenate([np.diff(road.points, axis=0) for road in roads])
    lengths = np.hypot(*steps.T)
    upright = np.abs(steps).min(axis=1) < _LEVEL * lengths
    return float(lengths[upright].sum() / max(float(lengths.sum()), 1e-9))


def _corners(roads: Sequence[FoundRoad], widths: Floats) -> int:
    """How many times roads of these widths (n,) turn on the spot by a right angle, straight before
    and after it."""
    steps = np.array([road.length / max(1, len(road.points) - 1) for road in roads])
    steps = np.maximum(steps, 1e-9)
    near = np.maximum(1, np.round((widths + _TURN) / steps)).astype(int)
    leg = np.maximum(1, np.round(np.maximum(_LEG * widths, _LEAST_LEG) / steps)).astype(int)
    count = 0
    for turn, way in set(zip(near.tolist(), leg.tolist(), strict=True)):
        alike = np.flatnonzero((near == turn) & (leg == way))
        lines = [_around(roads[index], turn + way) for index in alike.tolist()]
        owner = np.repeat(np.arange(len(alike)), [len(line) for line in lines])
        count += _turns(np.concatenate(lines), owner, (turn, way), steps[alike])
    return count


def _around(road: FoundRoad, reach: int) -> Floats:
    """The points of a road; of a closed one, so many again before and after its first."""
    points = road.points
    return np.concatenate([points[:-1], points[: 2 * reach + 1]]) if road.closed else points


def _turns(points: Floats, owner: NDArray[np.intp], reach: tuple[int, int], steps: Floats) -> int:
    """The right angles along lines (n, 2), given the line (n,) of each point and its step; a corner
    is so many points from its legs, and these are so many long."""
    near, leg = reach
    middle = np.arange(near + leg, len(points) - near - leg)
    middle = middle[owner[middle - near - leg] == owner[middle + near + leg]]
    before = points[middle - near] - points[middle - near - leg]
    after = points[middle + near + leg] - points[middle + near]
    long = [np.hypot(*way.T) for way in (before, after)]
    straight = np.minimum(*long) > _STRAIGHT * leg * steps[owner[middle]]
    cosine = (before * after).sum(axis=1) / np.maximum(long[0] * long[1], 1e-9)
    found = middle[straight & (np.abs(cosine) < _SQUARE)]
    return int(np.count_nonzero(np.diff(found, prepend=-2) > 1))
