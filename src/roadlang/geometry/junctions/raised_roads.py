"""How high roads are that pass over others, where maps say that they do, but not how high.

They rise to their level where they pass others, and are on the ground at their ends where roads of
the ground meet them.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ..arrays import Floats
from ..networks.network import Edge, RoadNetwork

LEVEL_HEIGHT = 6.0
"""Meters from one level to the next, where no map says it."""
_SLOPE = 0.05
"""Of ramps on average, where there is room."""
_BESIDE = 5.0
"""Meters beside what a road passes in which it keeps its height."""
_AT_NODE = 12.0
"""Meters around a node in which all roads have its height, where there is room."""
_SPACING = 2.0
_LEAST_AREA = 0.5

Need = tuple[float, float, float]
"""From and to which arc length a road has which height."""


def with_heights(network: RoadNetwork) -> RoadNetwork:
    """A network whose roads on other levels than the ground have `elevations`, and those that lead
    to them; the same where there are no levels, or where any road has elevations already."""
    edges = network.edges
    if all(edge.level == 0 for edge in edges) or any(e.elevations is not None for e in edges):
        return network
    ends = {node.id: LEVEL_HEIGHT * _node_level(network, node.id) for node in network.nodes}
    passed: dict[int, list[Need]] = {edge.id: [] for edge in edges}
    for id, need in _passed(network):
        passed[id].append(need)
    return replace(network, edges=tuple(_raised(edge, passed[edge.id], ends) for edge in edges))


def _node_level(network: RoadNetwork, node: int) -> int:
    """The level of most roads at a node; of two that are as many the one nearer to the ground."""
    levels = [edge.level for edge in network.edges_at(node)]
    return min(levels, key=lambda level: (-levels.count(level), abs(level)), default=0)


def _passed(network: RoadNetwork) -> Iterator[tuple[int, Need]]:
    """Where roads pass others of another level: their ids, and what they need there."""
    import shapely

    surfaces = np.array([_surface(edge) for edge in network.edges])
    first, second = shapely.STRtree(surfaces).query(surfaces, predicate="intersects")
    for i, j in sorted(zip(first.tolist(), second.tolist(), strict=True)):
        a, b = network.edges[i], network.edges[j]
        if i >= j or a.level == b.level:
            continue
        common = shapely.intersection(surfaces[i], surfaces[j])
        for node in {a.start, a.end} & {b.start, b.end}:
            near = shapely.Point(network.node(node).position).buffer(_AT_NODE + _width(a, b))
            common = shapely.difference(common, near)
        for piece in shapely.get_parts(common):
            if shapely.area(piece) > _LEAST_AREA:
                yield from ((edge.id, _need(edge, piece)) for edge in (a, b))


def _surface(edge: Edge) -> Any:
    import shapely

    s = edge.curve.stations(spacing=_SPACING)
    return shapely.LineString(edge.curve.at(s)).buffer(0.5 * _width(edge), cap_style="flat")


def _width(*edges: Edge) -> float:
    return max(float(np.max(edge.width.at([0.0, edge.length]))) for edge in edges)


def _need(edge: Edge, place: Any) -> Need:
    import shapely

    along, _ = edge.curve.project(shapely.get_coordinates(place))
    first, last = float(along.min()) - _BESIDE, float(along.max()) + _BESIDE
    return max(first, 0.0), min(last, edge.length), LEVEL_HEIGHT * edge.level


def _raised(edge: Edge, passed: list[Need], ends: Mapping[int, float]) -> Edge:
    """A road with elevations that fit where it passes others, and at its ends; as it is where all
    of it is on the ground."""
    heights = (ends[edge.start], ends[edge.end])
    if edge.curve.closed or not (any(heights) or any(need[2] for need in passed)):
        return edge
    first = min((need[0] for need in passed), default=edge.length)
    last = max((need[1] for need in passed), default=0.0)
    at_start, at_end = (min(_AT_NODE, 0.4 * room) for room in (first, edge.length - last))
    start = (0.0, at_start, heights[0])
    needs = [start, *sorted(passed), (edge.length - at_end, edge.length, heights[1])]
    s = np.linspace(0.0, edge.length, max(2, int(edge.length / _SPACING) + 1))
    return replace(edge, elevations=_profile(s, needs))


def _profile(s: Floats, needs: list[Need]) -> Floats:
    """Heights that are as needed, and smooth in between: ramps begin where the higher end is."""
    out = np.full(len(s), needs[0][2])
    for (_, before, low), (after, _, high) in itertools.pairwise(needs):
        length = min(max(after - before, 0.0), abs(high - low) / _SLOPE)
        begin = after - length if abs(high) > abs(low) else before
        share = np.clip((s - begin) / max(length, 1e-6), 0.0, 1.0)
        out = out + (high - low) * share * share * (3.0 - 2.0 * share)
    return out
