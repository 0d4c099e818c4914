"""Where the lines of agents cross junctions, and on which connections."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, wrapped_angle
from ...ir.road_heights import road_heights
from ...ir.scene import Scene
from ...ir.scene_junctions import SceneConnection, SceneJunction
from ..junctions.crossings import Crossings
from ..lines.route_lines import connection_points
from ..state.world import World
from .levels import apart_at

TURNED = 0.6
"""Radians: at its ends, a line without a route is turned from its connection by less than this."""
DETOUR = 1.5
"""A line takes a connection if it is at most so many times as long between its ends."""


@dataclass(frozen=True)
class _Crossing:
    stop: float
    exit: float
    junction: SceneJunction
    place: int


def crossings_of(world: World) -> Crossings:
    """The crossings of all agents of a world: of those with a route its turns, of others the
    connections that their lines follow. Joints, which nobody has to wait at, are left out."""
    numbers: dict[int, int] = {}
    junctions: list[SceneJunction] = []
    known: dict[Any, list[_Crossing]] = {}
    found: list[list[_Crossing]] = []
    places = [_places(scene) for scene in world.scenes]
    for agent, actor in enumerate(world.actors):
        crossed = places[agent // world.slots]
        if actor is None or not world.has_road[agent] or not crossed:
            found.append([])
        elif world.has_route[agent]:
            found.append(_of_route(world, agent, crossed))
        else:
            key = (int(world.track.row[agent]), *world.followed.kind(agent))
            if key not in known:
                known[key] = _of_line(world, agent, list(crossed.values()))
            found.append(known[key])
    for crossing in (crossing for row in found for crossing in row):
        if id(crossing.junction) not in numbers:
            numbers[id(crossing.junction)] = len(junctions)
            junctions.append(crossing.junction)
    shape = len(found), max(1, *(len(row) for row in found))
    stop, exit_ = np.full(shape, math.inf), np.full(shape, math.inf)
    junction, connection = np.full(shape, -1), np.full(shape, -1)
    for agent, row in enumerate(found):
        for place, crossing in enumerate(row):
            at = agent, place
            stop[at], exit_[at] = crossing.stop, crossing.exit
            junction[at], connection[at] = numbers[id(crossing.junction)], crossing.place
    return Crossings(stop, exit_, junction, connection, tuple(junctions))


def _places(scene: Scene) -> dict[Any, SceneJunction]:
    """The junctions of a scene at which somebody may have to wait. Of a network and those made from
    it, whose junctions are the same places, the last is built, so that its control holds."""
    built = {
        _place(junction): junction for network in scene.networks for junction in network.junctions
    }
    return {
        place: junction
        for place, junction in built.items()
        if junction.control.phases
        or any(conflict.kind != "diverge" for conflict in junction.conflicts)
    }


def _place(junction: SceneJunction) -> Any:
    return junction.id, junction.area[0]


def _of_route(world: World, agent: int, crossed: Mapping[Any, SceneJunction]) -> list[_Crossing]:
    table = world.table
    line = table.line[agent]
    begins, length = table.begin[line].tolist(), float(world.length[agent])
    out = []
    for leg, number in enumerate(table.turn[line].tolist()):
        junction = crossed.get(_place(table.turns[number].junction)) if number >= 0 else None
        if junction is None:
            continue
        place = _same_connection(table.turns[number].connection, junction)
        if place is None:
            junction = table.turns[number].junction
            place = junction.connections.index(table.turns[number].connection)
        begin = 0.0 if world.closed[agent] and leg == 0 else begins[leg]
        after = begins[leg + 1] if leg + 1 < len(begins) else math.inf
        out.append(_Crossing(begin, min(after, length), junction, place))
    return out


def _same_connection(wanted: SceneConnection, junction: SceneJunction) -> int | None:
    """The place among the connections of a junction of that which is the same but for the names of
    its roads; None where a network made from another has other lanes."""

    def lanes(connection: SceneConnection) -> Any:
        ends = connection.source, connection.target
        return connection.id, [(end.end, end.lane) for end in ends]

    places = (
        place
        for place, connection in enumerate(junction.connections)
        if lanes(connection) == lanes(wanted)
    )
    return next(places, None)


def _of_line(world: World, agent: int, crossed: Sequence[SceneJunction]) -> list[_Crossing]:
    """The connections that a line follows from end to end; where it ends within a junction, the
    straightest that it begins with."""
    lines, row = world.track.lines, int(world.track.row[agent])
    first = row * lines.cells
    cells = slice(first, first + int(lines.last[row]) + 1)
    heading = lines.heading[cells]
    along = lines.origin[row] + np.arange(len(heading)) * lines.spacing[row]
    offset = world.followed.offset(np.full(len(along), agent), along)
    points = np.stack(
        [lines.x[cells] - np.sin(heading) * offset, lines.y[cells] + np.cos(heading) * offset]
    )
    length = float(lines.length[row])
    out: dict[Any, tuple[float, _Crossing]] = {}
    for junction in crossed:
        for place, connection in enumerate(junction.connections):
            _, x, y, h = connection_points(connection)
            begin = _passed(points, heading, along, (x[0], y[0], h[0]), 0.5 * connection.widths[0])
            if begin is None or not 0.0 <= begin[0] < length:
                continue
            if world.heights is not None and _passes_over(world, agent, begin[0], connection):
                continue
            end = _passed(points, heading, along, (x[-1], y[-1], h[-1]), 0.5 * connection.widths[1])
            error, exit_ = _followed(connection, begin, end, length)
            key = (junction.id, round(begin[0]))
            if error < out.get(key, (math.inf, None))[0]:
                out[key] = error, _Crossing(begin[0], exit_, junction, place)
    return sorted((crossing for _, crossing in out.values()), key=lambda crossing: crossing.stop)


def _passes_over(world: World, agent: int, along: float, connection: SceneConnection) -> bool:
    """Whether a line is on another level, at an arc length, than a connection begins on."""
    scene, source = world.scenes[agent // world.slots], connection.source
    road = next(road for road in scene.roads if road.name == source.road)
    height = road_heights(scene)[road.name](
        np.array([0.0 if source.end == "start" else road.length])
    )
    return bool(apart_at(world, np.array([agent]), np.array([along]), height)[0])


def _followed(
    connection: SceneConnection,
    begin: tuple[float, float],
    end: tuple[float, float] | None,
    length: float,
) -> tuple[float, float]:
    """How far a line is from the ends of a connection, infinite if it does not follow it, and where
    on the line the connection ends."""
    if end is not None and 0.0 < end[0] - begin[0] < DETOUR * connection.length + 1.0:
        return begin[1] + end[1], end[0]
    if length - begin[0] < connection.length:
        turned = sum(abs(piece * curvature) for piece, curvature in connection.pieces)
        return 1e3 + turned, length
    return math.inf, math.inf


def _passed(
    points: Floats, heading: Floats, along: Floats, pose: Sequence[float], half: float
) -> tuple[float, float] | None:
    """Where a line passes a pose at most `half` meters to its side, and how far to its side."""
    off_x, off_y = points[0] - pose[0], points[1] - pose[1]
    nearest = int((off_x * off_x + off_y * off_y).argmin())
    cosine, sine = math.cos(pose[2]), math.sin(pose[2])
    ahead = cosine * off_x[nearest] + sine * off_y[nearest]
    left = cosine * off_y[nearest] - sine * off_x[nearest]
    turned = wrapped_angle(heading[nearest] - pose[2])
    spacing = along[1] - along[0]
    if abs(left) > half or abs(turned) > TURNED or abs(ahead) > spacing:
        return None
    return float(along[nearest] - ahead), abs(float(left))
