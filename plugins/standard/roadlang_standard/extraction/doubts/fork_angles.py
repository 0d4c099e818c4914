"""Angles at which roads meet: streets seldom leave one another like the strokes of a drawing."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from ..networks.found_network import FoundRoad

_AHEAD, _LEAST_WIDTH = 4.0, 2.0
"""The direction of a road is that to its point `_AHEAD` widths from the junction, each of at least
`_LEAST_WIDTH` pixels."""
_SHARP = 0.6
"""Two roads leave a sharp fork less than so many radians apart."""


def sharp_forks(roads: Sequence[FoundRoad], degree: NDArray[np.intp]) -> int:
    """At how many junctions, nodes (n,) of `degree` 3 and more, two roads leave side by side."""
    ways: dict[int, list[float]] = {}
    for road in roads:
        for node, points in ((road.start, road.points), (road.end, road.points[::-1])):
            if degree[node] > 2:
                ways.setdefault(node, []).append(_direction(road, points))
    return sum(_least_angle(directions) < _SHARP for directions in ways.values())


def _direction(road: FoundRoad, points: Floats) -> float:
    ahead = _AHEAD * max(_LEAST_WIDTH, road.usual_width)
    index = max(2, int(len(points) * min(1.0, ahead / max(road.length, 1e-9))))
    across, down = points[min(index, len(points) - 1)] - points[0]
    return float(np.arctan2(down, across))


def _least_angle(directions: Sequence[float]) -> float:
    around = np.sort(directions)
    return float(np.diff(np.append(around, around[0] + 2 * np.pi)).min())
