"""The state of agents in the middle of a drive, carried over to the world of an edited scene."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import SceneActor, SceneRoad
from ..state.world import World
from ..vehicles.motion import Motion, Track
from ..vehicles.poses import foot_points

SETTLING_TIME = 1.0
"""Seconds in which a line to follow moves to where its lane is after the edit."""
SEARCH = 30.0
"""Meters to each side of the old arc length in which a foot point is looked for first."""
ELSEWHERE, TURNED = 15.0, 20.0
"""Meters by which a line has to be nearer to count that is not there, or leads another way: roads
that cross would else capture who passes."""
WRONG_WAY = math.radians(60.0)


@dataclass(frozen=True)
class Continued:
    """Columns (R,) of the agents that go on: in the world before an edit, and in that after it."""

    before: Integers
    after: Integers

    @classmethod
    def of(cls, before: World, after: World, restarted: frozenset[str]) -> Continued:
        """Agents of the same name, but for groups or agents that are `restarted`."""
        known = {actor.name: row for row, actor in enumerate(before.actors) if actor is not None}
        rows = [
            (known[actor.name], row)
            for row, actor in enumerate(after.actors)
            if actor is not None and actor.name in known
            if not {actor.name, actor.group} & restarted
        ]
        columns = np.array(rows, dtype=np.int64).reshape(-1, 2)
        return cls(columns[:, 0], columns[:, 1])

    @property
    def is_everyone(self) -> bool:
        """Whether no agent has come, left or changed its column."""
        return bool(np.array_equal(self.before, self.after))


def carry_world(before: World, after: World, rows: Continued) -> None:
    """Agents of `after`, which is at its start, go on as they are in `before`: with their poses,
    speeds and counts, projected onto their lines."""
    after.tick = before.tick
    if not len(rows.after):
        return
    _carry_motion(before, after, rows)
    for name in ("contacts", "collision", "red_lights", "traveled", "began"):
        column = getattr(after, name).copy()
        column[rows.after] = getattr(before, name)[rows.before]
        setattr(after, name, column)
    for now, then in zip(after.pace, before.pace, strict=True):
        now[rows.after] = then[rows.before]
    _carry_lines(before, after, rows)


def _carry_motion(before: World, after: World, rows: Continued) -> None:
    poses = before.poses.take(rows.before)
    moving = before.motion.take(rows.before)
    track = after.track.of_rows(rows.after)
    walks = after.bodies.walks[rows.after]
    guess = nearest_nodes(track, poses.x, poses.y, poses.heading, moving.along, walks)
    along, offset, line_heading = foot_points(track, poses.x, poses.y, guess)
    error = poses.heading - line_heading
    there = replace(
        moving,
        along=track.wrapped(along),
        offset=offset,
        line_heading=line_heading,
        cosine=np.cos(error),
        sine=np.sin(error),
    )
    motion = after.motion
    for field in fields(Motion):
        column = getattr(motion, field.name).copy()
        column[rows.after] = getattr(there, field.name)
        setattr(motion, field.name, column)


def nearest_nodes(
    track: Track, x: Floats, y: Floats, heading: Floats, along: Floats, walks: Booleans
) -> Floats:
    """(R,) arc lengths of the nodes of lines that agents are most likely at: the nearest, where
    those near `along`, and for who does not walk those that lead the same way, count as nearer."""
    lines = track.lines
    grid = np.arange(lines.cells)
    nodes = track.first[:, None] + np.minimum(grid, track.last[:, None].astype(np.int64))
    station = track.origin[:, None] + grid * track.spacing[:, None]
    cost = np.hypot(lines.x[nodes] - x[:, None], lines.y[nodes] - y[:, None])
    away = np.abs(station - along[:, None])
    lap = np.where(track.closed, track.length, math.inf)[:, None]
    away = np.minimum(away, np.abs(lap - away))
    turned = np.cos(lines.heading[nodes] - heading[:, None]) < math.cos(WRONG_WAY)
    cost = cost + ELSEWHERE * (away > SEARCH) + TURNED * (turned & ~walks[:, None])
    best: Floats = np.take_along_axis(station, cost.argmin(axis=1)[:, None], axis=1)[:, 0]
    return best


def _carry_lines(before: World, after: World, rows: Continued) -> None:
    """Who has changed lanes stays in its lane, wherever that is now."""
    same = [
        _path(before, old) == _path(after, new)
        for old, new in zip(rows.before.tolist(), rows.after.tolist(), strict=True)
    ]
    old, new = rows.before[same], rows.after[same]
    place, pace = after.motion.along, after.motion.speed
    target = np.full(len(after.filled), math.nan)
    at_start = after.line_offset  # of the lines as they were at the start, beside the agents now
    after.followed.go_on(before.followed, new, old, before.motion.along[old])
    for then, now in zip(old.tolist(), new.tolist(), strict=True):
        settled = before.followed.is_as_at_start(then)
        target[now] = at_start[now] if settled else _moved_lane(before, after, then, now)
    after.followed.move(target, np.full(len(target), SETTLING_TIME), place, pace)


def _path(world: World, row: int) -> tuple[str | None, bool, bool]:
    actor = world.actors[row]
    return (actor.road if actor is not None else None, *_direction(world, row))


def _direction(world: World, row: int) -> tuple[bool, bool]:
    return bool(world.backward[row]), bool(world.has_route[row])


def _moved_lane(before: World, after: World, old: int, new: int) -> float:
    """Where the lane is now that an agent had changed to; the same offset where there is none."""
    target = float(before.followed.target(old, float(before.motion.along[old])))
    roads = [_road(world, row) for world, row in ((before, old), (after, new))]
    if roads[0] is None or roads[1] is None or after.has_route[new]:
        return target
    sign = -1.0 if before.backward[old] else 1.0
    section, station = roads[0].cross_section(), float(before.station[old])
    centers = {lane: float(section.offset(lane, station)) for lane in section.ids}
    lane = min(centers, key=lambda id: abs(centers[id] - sign * target), default=None)
    now = roads[1].cross_section()
    if lane is None or lane not in now.ids:
        return target
    moved = float(now.offset(lane, float(after.station[new])))
    return target + sign * (moved - centers[lane])


def _road(world: World, row: int) -> SceneRoad | None:
    actor: SceneActor | None = world.actors[row]
    if actor is None:
        return None
    roads = world.scenes[row // world.slots].roads
    return next((road for road in roads if road.name == actor.road), None)


def same_network(before: World, after: World) -> bool:
    """Whether an edit has changed nothing that right of way depends on: roads, junctions, where the
    lines of agents lead, and the ground that agents cover on them."""
    pairs = zip(before.scenes, after.scenes, strict=True)
    same_roads = all((a.roads, a.networks) == (b.roads, b.networks) for a, b in pairs)
    return same_roads and _ground(before) == _ground(after)


def _ground(world: World) -> list[object]:
    """Of each agent where it began, and what it covers there."""
    return [
        actor
        and (
            actor.name, actor.route, actor.road, actor.start, actor.lane, actor.offset,
            actor.facing, actor.length, actor.width,
            [actor.options.get(name) for name in ("wheelbase", "max_steering")],
        )
        for actor in world.actors
    ]  # fmt: skip
