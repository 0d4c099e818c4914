"""Handles of networks: junctions, ends of roads, and places between."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..geometry.arrays import Floats
from ..geometry.errors import GeometryError
from ..geometry.networks.warp import Warp
from ..ir.scene import Scene, SceneNetwork, SceneRoad
from ..syntax.network_edits import (
    NetworkMoves,
    found_network,
    network_moves_of,
    with_network_moves,
)
from ..syntax.text_edits import Place
from .handle import SPACING, Handle

NEAR = 1.0
"""Meters: handles closer than this would coincide."""
SAME = 0.02
"""Meters by which the place of a handle may differ from where its move leads, by rounding."""


def network_handles(text: str, scene: Scene) -> Iterator[Handle]:
    """Those of all networks that are shown and were found for this text."""
    driven = {actor.road for actor in scene.agents}
    roads = {road.name: road for road in scene.roads}
    for network in scene.networks:
        own = [roads[name] for name in network.roads]
        name = found_network(text, network.name)
        moves = None if name is None else network_moves_of(text, name)
        is_shown = any(road.derived or road.name in driven for road in own)
        if name is not None and moves is not None and is_shown and not _is_one_road(scene, network):
            yield from _handles(network, own, name, moves)


def network_dragged(text: str, handle: Handle, to: Place) -> str | None:
    """The text after a place of a network was dragged; None where the network would fold."""
    moves = network_moves_of(text, handle.name)
    if moves is None:
        return None
    delta = (to[0] - handle.x, to[1] - handle.y)
    number = _move_of(moves, handle)
    if number is not None:
        x, y = moves.by[number]
        total = (x + delta[0], y + delta[1])
        moves = replace(moves, by=(*moves.by[:number], total, *moves.by[number + 1 :]))
    else:
        x, y = _warp(moves).origin_of((handle.x, handle.y))
        place = (round(x, 2), round(y, 2))
        moves = replace(moves, at=(*moves.at, place), by=(*moves.by, delta))
    try:
        _warp(moves)
    except GeometryError:
        return None
    return with_network_moves(text, handle.name, moves)


@dataclass(frozen=True)
class NetworkMotion:
    """What becomes of the plane around a network by an edit that moves places of it."""

    before: Warp
    after: Warp

    def __call__(self, points: Floats) -> Floats:
        """(n, 2) where points come to lie, meters."""
        return self.after.moved(self.before.origins_of(points))


def network_motion(before: str, after: str, name: str) -> NetworkMotion | None:
    """The motion from one text to another; None where one has no moves that can be read."""
    found = network_moves_of(before, name), network_moves_of(after, name)
    if found[0] is None or found[1] is None:
        return None
    try:
        return NetworkMotion(_warp(found[0]), _warp(found[1]))
    except GeometryError:
        return None


def network_restored(text: str, handle: Handle) -> str | None:
    """The text with a place of a network where it was found; None where it was not moved."""
    moves = network_moves_of(text, handle.name)
    number = None if moves is None else _move_of(moves, handle)
    if moves is None or number is None:
        return None
    if len(moves.at) == 1:
        return with_network_moves(text, handle.name, replace(moves, by=((0.0, 0.0),)))
    at, by = ((*part[:number], *part[number + 1 :]) for part in (moves.at, moves.by))
    return with_network_moves(text, handle.name, replace(moves, at=at, by=by))


def _is_one_road(scene: Scene, network: SceneNetwork) -> bool:
    """Whether a road of its own runs over all of it: that has the handles."""
    return len(network.roads) == 1 and any(
        part.road in network.roads for road in scene.roads for part in road.along
    )


def _handles(
    network: SceneNetwork, roads: list[SceneRoad], name: str, moves: NetworkMoves
) -> Iterator[Handle]:
    nodes = [(node.x, node.y) for node in network.nodes]
    for node in network.nodes:
        yield Handle("junction" if len(node.roads) > 1 else "street", name, node.x, node.y)
    moved: list[Place] = []
    if moves.at:
        points = _warp(moves).moved(np.array(moves.at))
        moved = [(float(x), float(y)) for x, y in points]
    between = [place for place in moved if _distance(place, nodes) > NEAR]
    even = [
        place
        for road in roads
        for place in _even_places(road)
        if _distance(place, [*nodes, *between]) > 0.5 * SPACING
    ]
    for x, y in [*between, *even]:
        yield Handle("street", name, x, y)


def _even_places(road: SceneRoad) -> Iterator[Place]:
    count = max(1, round(road.length / SPACING))
    for station in np.linspace(0.0, road.length, count, endpoint=False)[1:]:
        at = int(np.searchsorted(road.stations, station).clip(0, len(road.x) - 1))
        yield road.x[at], road.y[at]


def _distance(place: Place, others: list[Place]) -> float:
    return min((math.dist(place, other) for other in others), default=math.inf)


def _move_of(moves: NetworkMoves, handle: Handle) -> int | None:
    """The number of the move that leads to a handle."""
    if not moves.at:
        return None
    away = _warp(moves).moved(np.array(moves.at)) - np.array([handle.x, handle.y])
    distances = np.hypot(*away.T)
    number = int(distances.argmin())
    return number if distances[number] < SAME else None


def _warp(moves: NetworkMoves) -> Warp:
    return Warp.of(moves.at, moves.by, moves.radius)
