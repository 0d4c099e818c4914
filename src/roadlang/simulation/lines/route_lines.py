"""The lines of agents with a route: along the middles of its lanes and through its junctions."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...geometry.arrays import Floats
from ...ir.scene import Scene, SceneRoad
from ...ir.scene_junctions import SceneConnection, SceneJunction
from ...ir.scene_route import RouteStep, RouteTurn, SceneRoute
from ...ir.surroundings import DEFAULT_SPEED
from .line_sources import LineSource
from .smoothing import drivable, is_tight

ARC_SPACING = 0.5
"""Meters between two points of a connection, at most."""
LANE_CHANGE_TIME = 3.0
"""Seconds that a lane change of a route takes at the speed limit."""
LANE_CHANGE_LENGTHS = (20.0, 120.0)
"""Meters, at least and at most, for a lane change of a route."""
COINCIDENT = 1e-6
"""Meters: points so close are the same."""


@dataclass(frozen=True)
class RouteConnection:
    """A connection through a junction."""

    junction: SceneJunction
    connection: SceneConnection


@dataclass(frozen=True)
class LineLeg:
    """A part of a line, from arc length `begin` on: on one lane of a road, or a connection."""

    step: int
    """of the route; a connection belongs to the step that it leaves"""
    road: int
    """number of the road in its scene, -1 for none; that of the step that a connection leaves"""
    lane: int
    """its id, 0 for none"""
    begin: float
    along: Floats
    """(n,) arc lengths of the line ..."""
    station: Floats
    """(n,) ... and those of the road there"""
    speed_limit: float
    """m/s, infinite for none"""
    turn: RouteConnection | None = None
    changed: float = 0.0
    """meters before and after its begin in which the line changes to its lane; 0: it does not"""


@dataclass(frozen=True)
class RouteLine:
    """A line with what it leads over."""

    source: LineSource
    legs: tuple[LineLeg, ...]
    aside: float = 0.0
    """meters by which it is moved, at or in a junction, to keep clear of what stands there"""


@dataclass(frozen=True)
class _Part:
    """Points of a part of a line before it is joined to others."""

    step: int
    x: Floats
    y: Floats
    heading: Floats
    width: Floats
    station: Floats
    turn: RouteConnection | None = None
    changed: float = 0.0


def plain_line(
    source: LineSource, number: int, road: SceneRoad | None, lane: int, backward: bool
) -> RouteLine:
    """The line of an agent without a route: all of its road (None: it is on none), with a leg for
    each of its speed zones."""
    length = source.length
    starts = [] if road is None else [zone.start for zone in road.speed_zones[1:]]
    if not starts:
        limit = math.inf if road is None else speed_limit(road, lane)
        along = np.array((0.0, length))
        station = along[::-1] if backward else along
        return RouteLine(source, (LineLeg(0, number, lane, 0.0, along, station, limit),))
    legs = []
    for zone, stations in enumerate(itertools.pairwise((0.0, *starts, length))):
        ends = np.array(stations)
        limit = math.inf if road is None else speed_limit(road, lane, zone)
        along = length - ends[::-1] if backward else ends
        station = ends[::-1] if backward else ends
        legs.append(LineLeg(0, number, lane, float(along[0]), along, station, limit))
    return RouteLine(source, tuple(legs[::-1] if backward else legs))


def route_line(route: SceneRoute, scene: Scene, numbers: Mapping[str, int]) -> RouteLine:
    """The line of a route. `numbers`: of the roads of the scene, by name."""
    parts = list(_parts(route, scene, numbers))
    s, points = 0.0, []
    legs: list[LineLeg] = []
    last: tuple[float, float, float] | None = None
    for part in parts:
        along = _arc_lengths(part, last)
        begin, along = s, s + along
        step = route.steps[part.step]
        road = scene.roads[numbers[step.road]]
        turned = part.turn is not None
        legs.append(
            LineLeg(
                part.step, numbers[step.road], 0 if turned else step.lane, begin, along,
                part.station, speed_limit(road, step.lane), part.turn, part.changed,
            )
        )  # fmt: skip
        points.append((along, part.x, part.y, part.heading, part.width))
        s = float(along[-1])
        last = float(part.x[-1]), float(part.y[-1]), float(part.heading[-1])
    columns = [np.concatenate(column) for column in zip(*points, strict=True)]
    fresh = np.append(True, np.diff(columns[0]) > COINCIDENT)
    along, x, y, heading, width = (column[fresh] for column in columns)
    return RouteLine(LineSource(along, x, y, np.unwrap(heading), width, route.closed), tuple(legs))


def route_points(scene: Scene, route: SceneRoute) -> tuple[Floats, Floats, Floats, Floats]:
    """x, y, heading and width (n,) along a route of a scene: of the middles of its lanes and of the
    connections between, as an agent follows them."""
    numbers = {road.name: number for number, road in enumerate(scene.roads)}
    source = route_line(route, scene, numbers).source
    return source.x, source.y, source.heading, np.broadcast_to(source.width, source.x.shape)


def speed_limit(road: SceneRoad, lane: int, zone: int = 0) -> float:
    """That of a lane, m/s: its own, or that of its road; infinite for none."""
    for one in road.lane_list:
        if one.id == lane:
            if one.speed_limit is not None:
                return one.speed_limit
            break
    limit = road.speed_zones[zone].speed_limit if road.speed_zones else road.speed_limit
    return math.inf if limit is None else limit


def turn_of(turn: RouteTurn, scene: Scene) -> RouteConnection:
    """The connection that a turn names."""
    network = next(candidate for candidate in scene.networks if candidate.name == turn.network)
    junction = next(candidate for candidate in network.junctions if candidate.id == turn.junction)
    connection = next(
        candidate for candidate in junction.connections if candidate.id == turn.connection
    )
    return RouteConnection(junction, connection)


def connection_points(connection: SceneConnection) -> tuple[Floats, Floats, Floats, Floats]:
    """(n,) arc length, x, y and heading of points of a connection, exactly on its arcs."""
    x, y, heading = connection.start
    s = 0.0
    rows = [(s, x, y, heading)]
    for length, curvature in connection.pieces:
        count = max(1, math.ceil(length / ARC_SPACING))
        turned = length * curvature / count
        chord = length / count
        if abs(turned) > 1e-9:
            chord *= math.sin(turned / 2) / (turned / 2)
        for _ in range(count):
            x += chord * math.cos(heading + turned / 2)
            y += chord * math.sin(heading + turned / 2)
            heading += turned
            s += length / count
            rows.append((s, x, y, heading))
    columns = np.array(rows).T
    return columns[0], columns[1], columns[2], columns[3]


def _parts(route: SceneRoute, scene: Scene, numbers: Mapping[str, int]) -> Iterator[_Part]:
    """Lanes and connections in order."""
    steps = route.steps
    count = len(steps)
    for number, step in enumerate(steps):
        road = scene.roads[numbers[step.road]]
        before = steps[number - 1] if number or route.closed else None
        after = steps[(number + 1) % count] if number + 1 < count or route.closed else None
        if before is not None and not _changes_lane(before, step):
            before = None
        if after is not None and not _changes_lane(step, after):
            after = None
        if abs(step.stop - step.start) > COINCIDENT:
            yield _lane_part(number, step, road, before, after)
        if step.turn is not None:
            yield _connection_part(number, step, turn_of(step.turn, scene))


def _changes_lane(before: RouteStep, after: RouteStep) -> bool:
    return before.turn is None and before.road == after.road and before.lane != after.lane


def _lane_part(
    number: int, step: RouteStep, road: SceneRoad, before: RouteStep | None, after: RouteStep | None
) -> _Part:
    """The middle of a lane, with one half of a lane change at either end where there is one."""
    stations = np.array(road.stations)
    low, high = min(step.start, step.stop), max(step.start, step.stop)
    inside = (stations > low + COINCIDENT) & (stations < high - COINCIDENT)
    changes = [
        (end, other, _change_length(step, other, road))
        for end, other in ((step.start, before), (step.stop, after))
        if other is not None
    ]
    extra = [
        np.arange(max(low, end - half), min(high, end + half), 1.0)
        for end, _, length in changes
        for half in (length / 2,)
    ]
    at = np.unique(np.concatenate([[low, high], stations[inside], *extra]))
    section = road.cross_section()
    offset = np.asarray(section.offset(step.lane, at))
    for end, other, length in changes:
        share = np.abs(at - end) / length
        rise = eased(np.maximum(0.5 - share, 0.0))
        offset = offset + rise * (np.asarray(section.offset(other.lane, at)) - offset)
    heading = np.interp(at, stations, np.unwrap(np.array(road.heading)))
    curvature = np.interp(at, stations, np.array(road.curvature))
    x = np.interp(at, stations, np.array(road.x)) - np.sin(heading) * offset
    y = np.interp(at, stations, np.array(road.y)) + np.cos(heading) * offset
    slope = np.gradient(offset, at) if len(at) > 2 else np.zeros(len(at))
    heading = heading + np.arctan(slope / np.maximum(1.0 - curvature * offset, 0.1))
    width = np.broadcast_to(np.asarray(section.lane_width(step.lane, at)), at.shape)
    if is_tight(curvature, offset):
        s = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
        even, x, y, heading = drivable(x, y)
        at, width = np.interp(even, s, at), np.interp(even, s, width)
    if step.start > step.stop:
        x, y, heading, width, at = x[::-1], y[::-1], heading[::-1] + np.pi, width[::-1], at[::-1]
    changed = 0.5 * _change_length(step, before, road) if before is not None else 0.0
    return _Part(number, x, y, heading, np.array(width), at, changed=changed)


def eased(u: Floats) -> Floats:
    """From 0 to 1 without a jerk: 10 u^3 - 15 u^4 + 6 u^5."""
    return np.asarray(u * u * u * (10.0 + u * (6.0 * u - 15.0)))


def _change_length(step: RouteStep, other: RouteStep, road: SceneRoad) -> float:
    """Meters along the road, one half of them on each of the two steps."""
    limit = speed_limit(road, step.lane)
    wanted = LANE_CHANGE_TIME * (limit if math.isfinite(limit) else DEFAULT_SPEED)
    wanted = min(max(wanted, LANE_CHANGE_LENGTHS[0]), LANE_CHANGE_LENGTHS[1])
    shorter = min(abs(step.stop - step.start), abs(other.stop - other.start))
    return max(min(wanted, 2.0 * shorter), COINCIDENT)


def _connection_part(number: int, step: RouteStep, turn: RouteConnection) -> _Part:
    """A connection; its station is that where the lane that it leaves ends."""
    s, x, y, heading = connection_points(turn.connection)
    share = s / s[-1]
    widths = turn.connection.widths
    width = widths[0] + (widths[1] - widths[0]) * share
    return _Part(number, x, y, heading, width, np.full(len(s), step.stop), turn)


def _arc_lengths(part: _Part, last: Any) -> Floats:
    """(n,) arc lengths of the points of a part, from the end of the part before it."""
    x, y, heading = part.x, part.y, part.heading
    gap = math.hypot(x[0] - last[0], y[0] - last[1]) if last is not None else 0.0
    chords = np.hypot(np.diff(x), np.diff(y))
    half = 0.5 * np.diff(heading)
    half = half - np.round(half / np.pi) * np.pi
    safe = np.where(np.abs(half) > 1e-9, half, 1.0)
    arcs = chords * np.where(np.abs(half) > 1e-9, safe / np.sin(safe), 1.0)
    return gap + np.concatenate([[0.0], np.cumsum(arcs)])
