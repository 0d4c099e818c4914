"""Pedestrians who step toward the lane of a car, or wait at a crossing, and vehicles that back into
it: where the car has to stop to let them pass."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..corridors import Window, looks_ahead
from ..crossings import Crossings
from ..poses import Poses
from ..world import World
from .approaches import braking_to_stop
from .junction_tables import SIGNALS, JunctionTables

MARGIN = 0.5
"""Meters to each side between a car and a pedestrian that it passes."""
BEFORE = 1.0
"""Meters before a pedestrian at which cars stop."""
STEPS = 0.3
"""m/s toward the lane from which on a pedestrian walks into it."""
SOON = 6.0
"""Seconds: who comes to the lane later does not count yet."""
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
    lane: Floats
    """meters of that lane across"""
    half_extent: Floats
    """half of the size of the pedestrian"""
    toward: Floats
    """m/s, of the pedestrian toward the lane"""
    faces: Booleans
    is_standing: Booleans


class Pedestrians:
    """Watched by the cars of a world."""

    def __init__(self, world: World, crossings: Crossings) -> None:
        tables = JunctionTables.of(crossings.junctions)
        free = np.append(tables.rule != SIGNALS, False)[crossings.junction]
        self._places = np.where(
            free[:, :, None], np.stack([crossings.stop, crossings.exit], axis=2), math.inf
        )
        self._waited = np.zeros(len(world.present))
        self._time = np.full(len(world.present), -math.inf)
        self._walkers = bool((world.bodies.walks & world.filled).any())

    def take(self, agents: Integers) -> None:
        """From now on the world has these of its agents alone."""
        self._places, self._waited = self._places[agents], self._waited[agents]
        self._time = self._time[agents]

    def ahead(self, world: World, poses: Poses, rows: Integers) -> Floats:
        """(n,) meters from the fronts of some agents to where they have to stop for a pedestrian,
        or for a vehicle that backs, infinite for nobody."""
        out = np.full(len(rows), math.inf)
        exist = self._walkers or bool(_backs(world).any())
        seen = _seen(world, poses, rows) if exist else None
        if seen is None:
            return out
        car = rows[seen.agent]
        speed, half = world.motion.speed[car], 0.5 * world.bodies.length[car]
        gap = seen.ahead - half - seen.half_extent
        stop = gap - BEFORE
        needs = (stop > -BEFORE) & (_steps_in(seen, gap, speed, half))
        courteous = self._wants_to_cross(world, seen, car) & (stop > -BEFORE)
        courteous &= braking_to_stop(speed, stop) < COURTEOUS
        courteous &= self._patient(world, rows, car, speed, courteous)
        needs |= courteous
        np.minimum.at(out, seen.agent[needs], stop[needs])
        return out

    def _wants_to_cross(self, world: World, seen: _Seen, car: Integers) -> Booleans:
        """(P,) who stands at a crossing without signals and faces it."""
        along = (world.motion.along[car] + seen.ahead)[:, None]
        first, last = CROSSING
        beyond = along - self._places[car, :, 0]
        before = self._places[car, :, 1] - along
        there = (beyond > first) & (beyond < last) | (before > first) & (before < last)
        close = (seen.outside > 0.0) & (seen.outside < AT_CURB)
        return np.asarray(seen.is_standing & seen.faces & close & there.any(axis=1))

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


def _steps_in(seen: _Seen, gap: Floats, speed: Floats, half: Floats) -> Booleans:
    """(P,) who will be in the lane as the car comes, if both go on as they do."""
    toward = np.maximum(seen.toward, 1e-3)
    enters = seen.outside / toward
    leaves = (seen.outside + seen.lane) / toward
    pace = np.maximum(speed, 1e-3)
    arrives = np.maximum(gap, 0.0) / pace
    passed = (gap + 2.0 * (half + seen.half_extent)) / pace
    steps = (seen.outside > 0.0) & (seen.toward > STEPS) & (enters < SOON)
    return np.asarray(steps & (passed + CLEARANCE > enters) & (leaves + CLEARANCE > arrives))


def _backs(world: World) -> Booleans:
    """(N,) which vehicles drive backward."""
    return np.asarray(world.present & (world.motion.speed < -STEPS))


def _seen(world: World, poses: Poses, rows: Integers) -> _Seen | None:
    """The pedestrians, and what backs, near the lines of some agents, if there are any."""
    walkers = np.flatnonzero(world.bodies.walks & world.present | _backs(world))
    same = (rows // world.slots)[:, None] == (walkers // world.slots)[None, :]
    view = looks_ahead(world)[rows][:, None]
    off_x = poses.x[walkers][None, :] - poses.x[rows][:, None]
    off_y = poses.y[walkers][None, :] - poses.y[rows][:, None]
    drives = (world.has_road & world.present & ~world.bodies.walks)[rows][:, None]
    near = same & drives & (walkers[None, :] != rows[:, None])
    near &= off_x * off_x + off_y * off_y < view * view
    place, number = np.nonzero(near)
    if not len(place):
        return None
    agents, column = np.unique(rows[place], return_inverse=True)
    window = Window.of(world, agents)
    walker = walkers[number]
    dx = poses.x[walker] - window.x[:, column]
    dy = poses.y[walker] - window.y[:, column]
    square = np.where(window.s[:, None] <= window.view[column], dx * dx + dy * dy, math.inf)
    sample, pair = square.argmin(axis=0), np.arange(len(walker))
    cosine, sine = window.cosine[sample, column], window.sine[sample, column]
    dx, dy = dx[sample, pair], dy[sample, pair]
    left = cosine * dy - sine * dx
    side = np.where(left > 0.0, -1.0, 1.0)
    turned = side * (cosine * np.sin(poses.heading[walker]) - sine * np.cos(poses.heading[walker]))
    speed, bodies = world.motion.speed[walker], world.bodies
    half_extent = 0.5 * np.maximum(bodies.length[walker], bodies.width[walker])
    half = 0.5 * bodies.width[rows[place]] + half_extent + MARGIN
    ahead = window.s[sample] + cosine * dx + sine * dy
    return _Seen(
        place, ahead, np.abs(left) - half, 2.0 * half, half_extent, speed * turned,
        turned > FACES, np.abs(speed) < STEPS,
    )  # fmt: skip
