"""Pedestrians who step toward the lane of a car, or wait at a crossing, riders beside it whose way
it crosses when it turns, and vehicles that back into it: where the car has to stop to let them
pass."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..junctions.crossings import Crossings
from ..state.world import World
from ..surroundings.corridors import SAMPLE_SPACING, Window
from ..surroundings.levels import apart_where_met, ground_heights
from ..surroundings.near_pairs import looks_ahead
from ..vehicles.poses import Poses
from .approaches import braking_to_stop
from .crosswalks import Crosswalks
from .junction_tables import SIGNALS, JunctionTables
from .stays_in_lane import SOON, TIMES, stay

MARGIN = 0.5
"""Meters to each side between a car and a pedestrian that it passes."""
BEFORE = 1.0
"""Meters before a pedestrian at which cars stop."""
STEPS = 0.3
"""m/s toward the lane from which on a pedestrian walks into it."""
STARTING = 2.0
"""m/s: who is slower counts as this fast."""
RIDES = 4.0
"""m/s: a rider who has started counts as at least this fast."""
CLEARANCE = 1.0
"""Seconds between a car and a pedestrian when one goes before the other."""
AT_CURB = 3.0
"""Meters from the lane at which who wants to cross waits, at most."""
FACES = 0.5
"""Sine of the angle to the line from which on a pedestrian faces the lane."""
PATIENCE = 4.0
"""Seconds for which a car waits for one who stands at a crossing."""
COURTEOUS = 3.0
"""m/s^2: who would have to brake harder for one who stands does not."""
FAR = 1e6
"""Meters from the lane, of who is on another level."""
CROSSING = (-1.0, 5.0)
"""Meters beyond a stop line, and before the end of a connection, between which people cross."""


@dataclass(frozen=True)
class _Seen:
    """Columns (P,) over pairs of a car and a pedestrian, or what backs, near its line."""

    agent: Integers
    """place among the cars that look"""
    ahead: Floats
    """meters along the line from the middle of the car"""
    outside: Floats
    """meters of the pedestrian from the lane of the car"""
    enters: Floats
    """seconds until it is in that lane if it goes on as now, infinite for who is not there soon"""
    leaves: Floats
    """seconds until it has left the lane again"""
    enters_at: Floats
    """meters along the line from the middle of the car to where it enters the lane"""
    nearest: Floats
    """the same to where it is in the lane, at least: who walks at a slant comes toward the car"""
    half_extent: Floats
    """half of the size of the pedestrian"""
    toward: Floats
    """m/s, of the pedestrian toward the lane"""
    toward_later: Floats
    """the same where it enters the lane: other than now where the car turns"""
    faces: Booleans
    is_standing: Booleans
    at_crosswalk: Booleans
    """who is at a crosswalk over which the line leads"""
    alongside: Booleans
    """who rides beside the lane, and is let pass when it is beside the car already"""

    @property
    def soon(self) -> Booleans:
        """Who enters the lane soon if it goes on as now."""
        return np.isfinite(self.enters)


class Pedestrians:
    """Watched by the cars of a world."""

    def __init__(self, world: World, crossings: Crossings) -> None:
        tables = JunctionTables.of(crossings.junctions)
        free = np.append(tables.rule != SIGNALS, False)[crossings.junction]
        self._places = np.where(
            free[:, :, None], np.stack([crossings.stop, crossings.exit], axis=2), math.inf
        )
        self._junctions = crossings.stop, crossings.exit
        self._scenes, self._crosswalks = world.scenes, Crosswalks.of(world.scenes)
        self._waited = np.zeros(len(world.present))
        self._time = np.full(len(world.present), -math.inf)
        self._rides_beside = _rides_beside(world)
        self._watched = world.bodies.walks | self._rides_beside
        self._any_watched = bool((self._watched & world.filled).any())

    def take(self, agents: Integers) -> None:
        """From now on the world has these of its agents alone."""
        self._places, self._waited = self._places[agents], self._waited[agents]
        self._time = self._time[agents]
        self._rides_beside, self._watched = self._rides_beside[agents], self._watched[agents]
        first, last = self._junctions
        self._junctions = first[agents], last[agents]

    def ahead(self, world: World, poses: Poses, rows: Integers) -> Floats:
        """(n,) meters from the fronts of some agents to where they have to stop for a pedestrian,
        a rider beside them or a vehicle that backs, infinite for nobody."""
        out = np.full(len(rows), math.inf)
        backs = _backs(world)
        exist = self._any_watched or np.count_nonzero(backs) > 0
        watched = self._watched & world.present | backs
        if self._scenes is not world.scenes:
            self._scenes, self._crosswalks = world.scenes, Crosswalks.of(world.scenes)
        beside = self._rides_beside
        seen = _seen(world, poses, rows, watched, beside, self._crosswalks) if exist else None
        if seen is None:
            return out
        car = rows[seen.agent]
        speed, half = world.motion.speed[car], 0.5 * world.bodies.length[car]
        own = half + seen.half_extent
        gap = seen.nearest - own
        toward = np.where(self._turns(world, seen, car), seen.toward_later, seen.toward)
        is_ahead = seen.enters_at > np.where(seen.alongside, -own, own)
        needs = (toward > STEPS) & is_ahead & _meet(seen, gap, speed, half)
        stop = seen.ahead - own - BEFORE
        courteous = self._wants_to_cross(world, seen, car) & (stop > -BEFORE)
        courteous &= braking_to_stop(speed, stop) < COURTEOUS
        courteous &= self._patient(world, rows, car, speed, courteous)
        stop = np.where(needs, np.minimum(stop, gap - BEFORE), stop)
        needs |= courteous
        np.minimum.at(out, seen.agent[needs], stop[needs])
        return out

    def _turns(self, world: World, seen: _Seen, car: Integers) -> Booleans:
        """(P,) who enters the lane in a junction, where people walk straight on. Along a road they
        follow its bends."""
        along = (world.motion.along[car] + np.where(seen.soon, seen.enters_at, 0.0))[:, None]
        first, last = self._junctions
        inside = (along > first[car] - AT_CURB) & (along < last[car] + AT_CURB)
        return np.asarray(seen.soon & inside.any(axis=1))

    def _wants_to_cross(self, world: World, seen: _Seen, car: Integers) -> Booleans:
        """(P,) who stands at a crossing without signals and faces it."""
        along = (world.motion.along[car] + seen.ahead)[:, None]
        first, last = CROSSING
        beyond = along - self._places[car, :, 0]
        before = self._places[car, :, 1] - along
        there = (beyond > first) & (beyond < last) | (before > first) & (before < last)
        there = (seen.outside < AT_CURB) & there.any(axis=1) | seen.at_crosswalk
        return np.asarray(seen.is_standing & seen.faces & (seen.outside > 0.0) & there)

    def _patient(
        self, world: World, rows: Integers, car: Integers, speed: Floats, waiting: Booleans
    ) -> Booleans:
        """(P,) whether a car has not waited too long yet. Counts for how long it has."""
        waits = np.zeros(len(self._waited), dtype=bool)
        waits[car[waiting & (speed < STEPS)]] = True
        step = np.where(np.isfinite(self._time[rows]), world.time - self._time[rows], 0.0)
        self._waited[rows] += np.where(waits[rows], np.maximum(step, 0.0), 0.0)
        is_moving = world.motion.speed[rows] > COURTEOUS
        self._waited[rows] = np.where(is_moving, 0.0, self._waited[rows])
        self._time[rows] = world.time
        return np.asarray(self._waited[car] < PATIENCE)


def _meet(seen: _Seen, gap: Floats, speed: Floats, half: Floats) -> Booleans:
    """(P,) who will be in the lane as the car comes, if both go on as they do. A car that hardly
    moves counts as fast as it is soon after it starts: else it creeps toward who walks."""
    arrives = np.maximum(gap, 0.0) / np.maximum(speed, STARTING)
    passed = np.maximum(gap + 2.0 * (half + seen.half_extent), 0.0) / np.maximum(speed, 1e-3)
    before = seen.soon & (seen.leaves + CLEARANCE > arrives)
    return np.asarray(before & (passed + CLEARANCE > seen.enters))


def _backs(world: World) -> Booleans:
    """(N,) which vehicles drive backward."""
    return np.asarray(world.present & (world.motion.speed < -STEPS))


def _rides_beside(world: World) -> Booleans:
    """(N,) who goes in a bike lane or on a sidewalk, beside the lanes of its route."""
    found = np.zeros(len(world.present), dtype=bool)
    for place in np.flatnonzero(world.has_route & world.filled & ~world.bodies.walks).tolist():
        actor = world.scenes[place // world.slots].agents[place % world.slots]
        found[place] = actor.route is not None and actor.lane != actor.route.steps[0].lane
    return found


def _seen(
    world: World,
    poses: Poses,
    rows: Integers,
    watched: Booleans,
    rides_beside: Booleans,
    crosswalks: Crosswalks,
) -> _Seen | None:
    """Those who are watched near the lines of some agents, if there are any. Who rides beside the
    lanes is watched by those in the lanes who go its way: of others the right of way decides."""
    place, walker = _near(world, poses, rows, watched, rides_beside)
    if not len(place):
        return None
    agents, column = np.unique(rows[place], return_inverse=True)
    window = Window.of(world, agents)
    bodies, speed = world.bodies, world.motion.speed[walker]
    half_extent = 0.5 * np.maximum(bodies.length[walker], bodies.width[walker])
    half = 0.5 * bodies.width[rows[place]] + half_extent + MARGIN
    square = _squares(window, column, poses.x[walker], poses.y[walker])
    crossed = crosswalks.at(walker // world.slots, poses.x[walker], poses.y[walker])
    curb = AT_CURB + crosswalks.width(crossed)
    reach = half + np.maximum(curb, SOON * np.abs(speed)) + np.maximum(*window.swept).max()
    close = np.flatnonzero(square.min(axis=0) < (reach + SAMPLE_SPACING) ** 2)
    if not len(close):
        return None
    place, column, walker, speed = place[close], column[close], walker[close], speed[close]
    half, half_extent, crossed = half[close], half_extent[close], crossed[close]
    starts = rides_beside[walker] & (speed > STEPS)
    speed = np.where(starts, np.maximum(speed, RIDES), speed)
    pace = speed * np.cos(poses.heading[walker]), speed * np.sin(poses.heading[walker])
    x = poses.x[walker] + TIMES[:, None] * pace[0]
    y = poses.y[walker] + TIMES[:, None] * pace[1]
    ahead, left, outside, line = _on_lines(window, column, x, y, half)
    _leave_out_other_levels(world, rows[place], walker, (ahead, outside, crossed))
    line_x, line_y = x[0] + left[0] * np.sin(line[0]), y[0] - left[0] * np.cos(line[0])
    side = np.where(left[0] > 0.0, -1.0, 1.0)
    turned = side * np.sin(poses.heading[walker] - line)
    enters, leaves, first, nearest = stay(outside, ahead)
    later = turned[first, np.arange(len(walker))]
    return _Seen(
        place, ahead[0], outside[0], enters, leaves, ahead[first, np.arange(len(walker))], nearest,
        half_extent, speed * turned[0], speed * later, turned[0] > FACES, np.abs(speed) < STEPS,
        crosswalks.covers(crossed, line_x, line_y), rides_beside[walker],
    )  # fmt: skip


def _leave_out_other_levels(
    world: World, car: Integers, walker: Integers, seen: tuple[Floats, Floats, Integers]
) -> None:
    """Pairs (P,) of which one is on another level are far away. `seen`: how far ahead and outside
    the lane (T, P), and the crosswalk (P,)."""
    if world.heights is not None:
        apart = apart_where_met(world, car, seen[0][0], ground_heights(world)[walker])
        seen[1][:, apart], seen[2][apart] = FAR, -1


def _near(
    world: World, poses: Poses, rows: Integers, watched: Booleans, rides_beside: Booleans
) -> tuple[Integers, Integers]:
    """Pairs of one of some agents, by its place in `rows`, and one who is watched and that it may
    see."""
    walkers = np.flatnonzero(watched)
    same = (rows // world.slots)[:, None] == (walkers // world.slots)[None, :]
    view = looks_ahead(world)[rows][:, None]
    off_x = poses.x[walkers][None, :] - poses.x[rows][:, None]
    off_y = poses.y[walkers][None, :] - poses.y[rows][:, None]
    drives = (world.has_road & world.present & ~world.bodies.walks)[rows][:, None]
    near = same & drives & (walkers[None, :] != rows[:, None])
    same_way = np.cos(poses.heading[walkers][None, :] - poses.heading[rows][:, None]) > 0.0
    near &= ~rides_beside[walkers] | same_way & ~rides_beside[rows][:, None]
    near &= off_x * off_x + off_y * off_y < view * view
    place, number = np.nonzero(near)
    return place, walkers[number]


def _squares(window: Window, column: Integers, x: Floats, y: Floats) -> Floats:
    """(M, ...) squared distances of points (..., P) from the lines ahead."""
    extra = (1,) * (x.ndim - 1)
    shape = (len(window.s), *extra, len(column))
    dx, dy = x - window.x[:, column].reshape(shape), y - window.y[:, column].reshape(shape)
    seen = window.s[:, None] <= window.view[column]
    return np.asarray(np.where(seen.reshape(shape), dx * dx + dy * dy, math.inf))


def _on_lines(
    window: Window, column: Integers, x: Floats, y: Floats, half: Floats
) -> tuple[Floats, Floats, Floats, Floats]:
    """Of points (T, P) beside the lines ahead: meters along the line, and left of it, meters
    outside what the car covers there, and the heading of the line."""
    sample = _squares(window, column, x, y).argmin(axis=0)
    dx, dy = x - window.x[sample, column], y - window.y[sample, column]
    cosine, sine = window.cosine[sample, column], window.sine[sample, column]
    left = cosine * dy - sine * dx
    to_left, to_right = window.swept
    covered = half + np.where(left > 0.0, to_left[sample, column], to_right[sample, column])
    ahead = window.s[sample] + cosine * dx + sine * dy
    return ahead, left, np.abs(left) - covered, np.arctan2(sine, cosine)
