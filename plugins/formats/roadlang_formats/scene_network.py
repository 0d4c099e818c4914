"""The network of a scene: its roads as they were built, and its junctions as they were planned."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from roadlang.geometry import (
    CrossSection,
    Curve,
    Edge,
    Floats,
    GeometryError,
    LaneEnd,
    MapJunction,
    MapTurn,
    Node,
    OffsetProfile,
    RoadNetwork,
    WidthProfile,
    poses_along,
)

from .surfaces.built import built_roads

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneConnection, SceneJunction, SceneRoad

_SPACING = 0.5
_SHORTEST = 1e-6
"""Meters of a road, and of a piece of a turn."""
_MOST_TURNING = 20.0 * math.pi
"""Radians of a piece of a turn."""
_LONGEST = 10_000.0
"""Meters of a piece of a turn."""


def network_of(scene: Scene) -> RoadNetwork:
    """Roads keep the numbers of their network, if there is only one; they end where their junctions
    begin. Raises GeometryError for impossible ones."""
    junctions = [junction for network in scene.networks for junction in network.junctions]
    built = [road for road in built_roads(scene) if road.length - sum(road.trim) > _SHORTEST]
    numbers = _numbers(built)
    nodes: list[Node] = []
    edges = []
    for road in built:
        edges.append(_edge(road, numbers[road.name], nodes))
    stated = [
        _junction(place, junction, numbers)
        for place, junction in enumerate(junctions)
        if junction.connections and {arm.road for arm in junction.arms} <= numbers.keys()
    ]
    origins = [network.origin for network in scene.networks if network.origin is not None]
    return RoadNetwork(tuple(nodes), tuple(edges), origins[0] if origins else None, tuple(stated))


def _numbers(roads: list[SceneRoad]) -> Mapping[str, int]:
    edges = [road.edge for road in roads]
    if None not in edges and len(set(edges)) == len(edges):
        return {road.name: int(road.edge or 0) for road in roads}
    return {road.name: number for number, road in enumerate(roads)}


def _edge(road: SceneRoad, number: int, nodes: list[Node]) -> Edge:
    curve = Curve.hermite(np.column_stack((road.x, road.y)), road.heading, closed=road.closed)
    section = road.cross_section()
    start, stop = road.trim[0], road.length - road.trim[1]
    scale = curve.length / road.length
    is_cut = road.trim[0] > 0.0 or road.trim[1] > 0.0
    if is_cut:
        curve = curve.between(start * scale, stop * scale)
        section = _part(section, np.array(road.stations), start, stop, curve.length)
    ends = [0.0] if curve.closed else [0.0, curve.length]
    first = len(nodes)
    for place, (x, y) in enumerate(curve.at(np.array(ends))):
        nodes.append(Node(first + place, (float(x), float(y))))
    edge = Edge.of(number, first, first + len(ends) - 1, curve, section)
    heights = None
    if road.elevation:
        at = np.linspace(start, stop, len(road.elevation))
        heights = np.interp(at, road.stations, road.elevation)
    return replace(edge, name=road.street, elevations=heights)


def _part(
    section: CrossSection, stations: Floats, start: float, stop: float, length: float
) -> CrossSection:
    """The lanes between two stations, along a curve of this length."""
    inner = stations[(stations > start + _SHORTEST) & (stations < stop - _SHORTEST)]
    s = np.concatenate(([start], inner, [stop]))
    along = (s - start) * (length / (stop - start))
    lanes = tuple(
        replace(lane, width=WidthProfile(along, lane.width.at(s))) for lane in section.lanes
    )
    offset = section.center_offset
    if offset is not None:
        offset = OffsetProfile(along, offset.at(s))
    return replace(section, lanes=lanes, center_offset=offset)


def _junction(id: int, junction: SceneJunction, numbers: Mapping[str, int]) -> MapJunction:
    turns = tuple(
        MapTurn(
            LaneEnd(numbers[item.source.road], item.source.end, item.source.lane),
            LaneEnd(numbers[item.target.road], item.target.end, item.target.lane),
            _line(item),
        )
        for item in junction.connections
    )
    arms = tuple((numbers[arm.road], arm.end) for arm in junction.arms)
    return MapJunction(id, arms, turns, junction.kind == "joint")


def _line(connection: SceneConnection) -> Curve | None:
    """The curve of a connection; None for one without length."""
    pose = np.array(connection.start)
    found = [pose]
    for length, curvature in connection.pieces:
        if length <= _SHORTEST:
            continue
        if not length <= _LONGEST:
            raise GeometryError(f"a turn has a piece of {length:g} m")
        if not abs(curvature) * length <= _MOST_TURNING:
            raise GeometryError(f"a turn has a piece of {length:g} m with {curvature:g}/m")
        stations = np.linspace(0.0, length, max(2, math.ceil(length / _SPACING) + 1))
        poses = poses_along(pose, (curvature, curvature), stations)
        found += list(poses[1:])
        pose = poses[-1]
    if len(found) < 2:
        return None
    table = np.array(found)
    return Curve.hermite(table[:, :2], table[:, 2])
