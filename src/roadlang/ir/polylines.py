"""Polylines to a road network: ends that coincide are joined."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..geometry import Curve, Edge, GeometryError, Node, RoadNetwork
from ..geometry.arrays import FARTHEST, finite_points

DEFAULT_WIDTH = 7.0
"""Meters: two lanes of 3.5 m, where a source tells no width."""


def network_of_polylines(
    lines: Sequence[NDArray[np.float64]], width: float | None = None, tolerance: float = 1e-6
) -> RoadNetwork:
    """The network of (n, 2) polylines in meters, smoothed by splines through their points.

    Ends nearer than `tolerance` become one node, at their mean. A line whose two ends coincide is
    a loop. Raises `GeometryError` for a line without two distinct points, for numbers that are not
    finite, and for a width that is not positive.
    """
    lines = [
        finite_points(line, f"the points of polyline {index}") for index, line in enumerate(lines)
    ]
    for index, line in enumerate(lines):
        if len(line) < 2:
            count = f"{len(line)} point{'' if len(line) == 1 else 's'}"
            raise GeometryError(f"polyline {index} has {count}: it needs two or more")
    if width is not None and not 0.0 < width < FARTHEST:
        raise GeometryError(f"a width must be positive, but it is {width:g} m")
    ends = np.array([line[index] for line in lines for index in (0, -1)]).reshape(-1, 2)
    groups = _groups(ends, tolerance)
    positions = [ends[groups == group].mean(axis=0) for group in range(groups.max(initial=-1) + 1)]
    edges = []
    for index, line in enumerate(lines):
        start, end = int(groups[2 * index]), int(groups[2 * index + 1])
        loop = start == end and len(line) > 3
        points = np.array(line, dtype=float)
        points[0], points[-1] = positions[start], positions[end]
        curve = Curve.through(points[:-1] if loop else points, closed=loop)
        widths = np.full(2, DEFAULT_WIDTH if width is None else width)
        edges.append(Edge(index + 1, start, end, curve, widths))
    nodes = tuple(Node(id, (float(x), float(y))) for id, (x, y) in enumerate(positions))
    return RoadNetwork(nodes, tuple(edges))


def _groups(points: NDArray[np.float64], tolerance: float) -> NDArray[np.int64]:
    """(n,) the number of the group that each point belongs to, counted in order of appearance."""
    groups = np.full(len(points), -1, dtype=np.int64)
    for index, point in enumerate(points):
        if groups[index] < 0:
            near = np.hypot(*(points - point).T) <= tolerance
            groups[near & (groups < 0)] = groups.max() + 1
    return groups
