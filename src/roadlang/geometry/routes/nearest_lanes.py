"""The places in lanes that are nearest to points."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ..arrays import Floats
from .lane_graph import LaneGraph
from .legs import RoutePlace

_AT_JUNCTION = 10.0
"""Meters: how much farther than the nearest the other roads of a junction may be for a point in it,
which stands for all of them"""
_OTHER_SIDE = 1.0
"""What a meter farther from the middle of a lane costs a route, in meters"""


@dataclass(frozen=True, eq=False)
class NearRoads:
    """Roads (E,) of a graph beside points (n,): arrays (E, n)."""

    edges: tuple[int, ...]
    station: Floats
    """arc length of the nearest place outside the junctions"""
    beyond: Floats
    """meters that the nearest place of the road lies inside a junction"""
    distance: Floats
    """from the surface of the lanes, meters; negative on it"""
    across: tuple[Floats, ...]
    """(lanes, n) by road: meters from the middle of each lane, in the order of the graph"""

    def options(
        self, graph: LaneGraph, point: int, allowed: Callable[[int], bool]
    ) -> tuple[RoutePlace, ...]:
        """The places of a point: in the lanes of the nearest road, and of a point in a junction in
        those of all its roads. `allowed` says which lanes of the graph count."""
        nearest = int(np.argmin(self.distance[:, point]))
        numbers = [nearest]
        if self.beyond[nearest, point] > 1e-6:
            close = self.distance[:, point] <= self.distance[nearest, point] + _AT_JUNCTION
            numbers = np.flatnonzero(close & (self.beyond[:, point] > 1e-6)).tolist()
        return tuple(
            RoutePlace(lane, float(self.station[number, point]), _OTHER_SIDE * float(across))
            for number in numbers
            for lane, across in zip(
                graph.of_edge[self.edges[number]], self.across[number][:, point], strict=True
            )
            if allowed(lane)
        )


def near_roads(graph: LaneGraph, points: Floats) -> NearRoads:
    """How the roads of a graph lie to points (n, 2), meters."""
    if len(points) == 1:
        x, y = points[0].tolist()
        return _near_point(graph, x, y)
    return _near_points(graph, points)


@lru_cache(maxsize=256)
def _near_point(graph: LaneGraph, x: float, y: float) -> NearRoads:
    """The points of a route that the file says are the same in every scene."""
    return _near_points(graph, np.array([[x, y]]))


def _near_points(graph: LaneGraph, points: Floats) -> NearRoads:
    edges = tuple(graph.of_edge)
    stations, beyond, distances, across = [], [], [], []
    for edge in edges:
        curve, section = graph.edges[edge].curve, graph.sections[edge]
        lanes = graph.of_edge[edge]
        ends = graph.begin[lanes[0]], graph.end[lanes[0]]
        s = curve.project(points)[0]
        inside = np.clip(s, min(ends), max(ends))
        foot, heading = curve.at(inside), curve.heading(inside)
        normal = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
        gaps, widths = [], []
        for lane in lanes:
            id = graph.lanes[lane].lane
            middle = foot + section.offset(id, inside)[:, None] * normal
            gaps.append(np.hypot(*(points - middle).T))
            widths.append(section.lane_width(id, inside))
        stations.append(inside)
        beyond.append(np.abs(s - inside))
        across.append(np.stack(gaps))
        distances.append((np.stack(gaps) - np.stack(widths) / 2.0).min(axis=0))
    station, outside, distance = (np.stack(part) for part in (stations, beyond, distances))
    return NearRoads(edges, station, outside, distance, tuple(across))
