"""Road networks from polylines: ends that coincide become nodes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import FARTHEST, Floats, Integers, finite_points, norm
from ..curves.curve import Curve
from ..curves.waypoint_curve import through_waypoints
from ..errors import GeometryError
from .network import Edge, Node, RoadNetwork

DEFAULT_WIDTH = 7.0
"""Meters: two lanes of 3.5 m, where a source tells no width."""


def network_of_polylines(
    lines: Sequence[ArrayLike],
    width: float | Sequence[ArrayLike] | None = None,
    tolerance: float = 1e-6,
) -> RoadNetwork:
    """The network of polylines, each (n, 2) points in meters, smoothed by splines through them
    that keep to the straight line where a line has legs of very different lengths.

    Ends no farther apart than `tolerance` become one node, at their mean; a line whose two ends are
    one and that has four points or more is a loop. Edges are numbered from 1, in the order of the
    lines. `width`: meters, of all roads (7 by default) or of each: a number, or (m,) at even
    distances along it. Raises GeometryError for points that are not finite pairs, for a line
    without two distinct points, and for widths that are not positive.
    """
    points = [_line(line, index) for index, line in enumerate(lines)]
    if not 0.0 <= tolerance < np.inf:
        raise GeometryError("a tolerance must be a length, zero or more")
    ends = np.array([line[end] for line in points for end in (0, -1)]).reshape(-1, 2)
    nodes = _groups(ends, tolerance)
    positions = [ends[nodes == node].mean(axis=0) for node in range(nodes.max(initial=-1) + 1)]
    edges = []
    for index, (line, widths) in enumerate(zip(points, _widths(width, len(points)), strict=True)):
        start, end = (int(node) for node in nodes[2 * index : 2 * index + 2])
        curve = _curve(line, positions[start], positions[end], joined=start == end)
        edges.append(Edge(index + 1, start, end, curve, widths))
    return RoadNetwork(
        tuple(Node(id, (float(x), float(y))) for id, (x, y) in enumerate(positions)), tuple(edges)
    )


def _line(line: ArrayLike, index: int) -> Floats:
    points = finite_points(line, f"the points of polyline {index}")
    if len(points) < 2:
        count = f"{len(points)} point{'' if len(points) == 1 else 's'}"
        raise GeometryError(f"polyline {index} has {count}: it needs two or more")
    return points


def _widths(width: float | Sequence[ArrayLike] | None, count: int) -> list[Floats]:
    """(m,) widths of each line."""
    each: list[ArrayLike]
    if isinstance(width, Sequence):
        each = list(width)
        if len(each) != count:
            raise GeometryError(f"{count} lines need as many widths, not {len(each)}")
    else:
        each = [DEFAULT_WIDTH if width is None else width] * count
    found = [_width(item) for item in each]
    return [np.repeat(item, 2) if len(item) == 1 else item for item in found]


def _width(values: ArrayLike) -> Floats:
    """(m,) positive meters."""
    widths = np.asarray(values, dtype=np.float64).reshape(-1)
    wrong = widths[~((widths > 0.0) & (widths < FARTHEST))]
    if len(wrong) or not len(widths):
        shown = f"{wrong[0]:g} m" if len(wrong) else "missing"
        raise GeometryError(f"a width must be positive, but it is {shown}")
    return widths


def _curve(line: Floats, start: Floats, end: Floats, joined: bool) -> Curve:
    closed = joined and len(line) > 3
    points = line.copy()
    points[0], points[-1] = start, end
    return through_waypoints(points[:-1] if closed else points, closed)


def _groups(points: Floats, tolerance: float) -> Integers:
    """(n,) the number of the group that each point belongs to, counted in order of appearance."""
    groups = np.full(len(points), -1, dtype=np.int64)
    for index, point in enumerate(points):
        if groups[index] < 0:
            near = norm(points - point) <= tolerance
            groups[near & (groups < 0)] = groups.max() + 1
    return groups
