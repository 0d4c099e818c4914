"""Who is next ahead in the lane."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..vehicles.poses import Poses
from .corridors import looks_ahead, nearest_in_corridor
from .outlines import Outlines

SAME_LANE = 2.0
"""Meters: cars are beside each other rather than behind one another, from here on."""
CLEARANCE = 0.03
"""Seconds of its speed: so much more room beside what it passes does a driver want, up to
`SAME_LANE`. Who crawls in a jam lets a motorcycle ride between the lanes."""
COMING, STRAYING = 0.7, 0.1
"""Seconds ahead at which drivers see who comes over into their lane, and m/s to the side with which
nobody does."""
ALONG = 0.05
"""Sine of the angle to the road up to which somebody drives along it."""
MARGIN = 0.15
"""Meters to each side between two that pass each other."""


@dataclass(frozen=True)
class Leaders:
    """Who is ahead of whom."""

    gaps: Floats
    """(S, A, A) from the first to the second along the line of the first, infinite for what is not
    in its lane ahead"""
    gap: Floats
    """(N,) to the next agent"""
    speed: Floats
    """(N,) of that one, along the lane"""
    acceleration: Floats
    """(N,) of that one, along the lane"""
    turned: Floats
    """(S, A, A) radians by which the second is turned from the line of the first"""

    def without(self, world: World, pairing: Pairing, ignored: Booleans) -> Leaders:
        """Who is ahead where some agents (N,) do not count."""
        gaps = np.where(ignored.reshape(len(self.gaps), 1, -1), math.inf, self.gaps)
        return _next_ahead(world, pairing, gaps, self.turned)


@dataclass(frozen=True)
class Pairing:
    """Who of a scene can be ahead of whom: what of it does not change."""

    on_road: Booleans
    """(S, A, A) of two on one road"""
    elsewhere: Booleans
    """(S, A, A) of all others with a road, but itself"""
    radius: Floats
    """(S, A) around a footprint"""
    scene: Integers
    """(S, 1)"""
    agent: Integers
    """(1, A)"""

    @classmethod
    def of(cls, world: World) -> Pairing:
        """Of the agents of a world."""
        shape = (len(world.scenes), world.slots)
        pairs = world.has_road.reshape(shape)[:, :, None] & ~np.eye(shape[1], dtype=bool)[None]
        road = np.where(world.has_route, -1, world.road).reshape(shape)
        on_road = pairs & (road[:, :, None] == road[:, None, :]) & (road >= 0)[:, :, None]
        radius = 0.5 * (world.bodies.length + world.bodies.width).reshape(shape)
        scene, agent = np.ogrid[: shape[0], : shape[1]]
        return cls(on_road, pairs & ~on_road, radius, scene, agent)

    @cached_property
    def exists(self) -> tuple[bool, bool]:
        """Whether there are pairs on one road, and others."""
        return bool(self.on_road.any()), bool(self.elsewhere.any())


def leaders(world: World, poses: Poses, pairing: Pairing) -> Leaders:
    """Who is ahead in the lane of each agent. Of two on one road their stations say it; what else
    is near is looked for along the line."""
    shape = (len(world.scenes), world.slots)
    there = world.present.reshape(shape)
    both = there[:, :, None] & there[:, None, :]
    gap = np.full(both.shape, math.inf)
    has_road_mates, has_others = pairing.exists
    if has_road_mates:
        gap = np.where(pairing.on_road & both, _gaps_on_roads(world, shape), gap)
    heading = poses.heading.reshape(shape)
    turned = heading[:, None, :] - heading[:, :, None]
    if has_others:
        _search(world, poses, (pairing.elsewhere & both, pairing.radius), gap, turned)
    return _next_ahead(world, pairing, gap, turned)


def _next_ahead(world: World, pairing: Pairing, gap: Floats, turned: Floats) -> Leaders:
    """The nearest of all that are ahead."""
    shape = (len(world.scenes), world.slots)
    first = gap.argmin(axis=2)
    scene, agent = pairing.scene, pairing.agent
    least, turn = gap[scene, agent, first], turned[scene, agent, first]
    along = np.where(np.isfinite(least), np.cos(turn), 0.0)
    speed = along * world.motion.speed.reshape(shape)[scene, first]
    acceleration = along * world.motion.acceleration.reshape(shape)[scene, first]
    return Leaders(gap, least.ravel(), speed.ravel(), acceleration.ravel(), turned)


def _gaps_on_roads(world: World, shape: tuple[int, int]) -> Floats:
    """(S, A, A) gap of the first to the second, if both are on the road of the first: infinite for
    what is behind or beside it."""
    sign = np.where(world.backward, -1.0, 1.0).reshape(shape)
    station = world.station.reshape(shape)
    left = (np.where(world.backward, -1.0, 1.0) * world.motion.offset).reshape(shape)
    ahead = sign[:, :, None] * (station[:, None, :] - station[:, :, None])
    beside = sign[:, :, None] * left[:, None, :]
    road = world.length.reshape(shape)[:, :, None]
    if world.track.has_closed:
        closed = world.closed.reshape(shape)[:, :, None]
        ahead = np.where(closed, ahead - np.floor(ahead / road) * road, ahead)
    offset = _offsets_beside(world, shape, ahead)
    length = world.bodies.length.reshape(shape)
    gap = ahead - 0.5 * (length[:, :, None] + length[:, None, :])
    aside = beside - offset
    room = _in_the_way(world, shape)
    drift = sign * (world.motion.speed * world.motion.sine).reshape(shape)
    if (np.abs(drift) > STRAYING).any():
        comes = -np.sign(aside) * sign[:, :, None] * drift[:, None, :]
        room = room + COMING * np.maximum(comes - STRAYING, 0.0)
    fits = (ahead > 0.0) & (np.abs(aside) < room)
    return np.where(fits, gap, math.inf)


def _offsets_beside(world: World, shape: tuple[int, int], ahead: Floats) -> Floats:
    """(S, A, A) how far left of the center line the line of the first is beside the second, which
    is `ahead` of it; (S, A, 1) where the lines stay where they are."""
    if world.followed.guides.is_empty:
        return world.line_offset.reshape(shape)[:, :, None]
    rows = np.arange(len(world.present)).reshape(shape)[:, :, None]
    along = world.motion.along[rows] + ahead
    lap = np.where(world.closed, world.length, math.inf)[rows]
    return world.followed.offset(rows, along - np.where(along >= lap, lap, 0.0))


def _in_the_way(world: World, shape: tuple[int, int]) -> Floats:
    """(S, A, A) how far beside the line of the first the middle of the second is in its way: who is
    wide, or turned toward the lane, takes more of the road, and who is fast passes at a greater
    distance."""
    bodies = world.bodies
    turned = np.abs(world.motion.sine)
    along = np.sqrt(1.0 - np.minimum(turned * turned, 1.0))
    across = 0.5 * bodies.length * np.maximum(turned - ALONG, 0.0)
    half = (0.5 * bodies.width * along + across + MARGIN).reshape(shape)
    own = 0.5 * bodies.width.reshape(shape)[:, :, None]
    clearance = CLEARANCE * world.motion.speed.reshape(shape)[:, :, None]
    most = SAME_LANE - half[:, None, :]
    return np.asarray(np.maximum(np.minimum(own + clearance, most), own) + half[:, None, :])


def _search(
    world: World, poses: Poses, apart: tuple[Booleans, Floats], gap: Floats, turned: Floats
) -> None:
    """Fill in the gaps to agents that are not on the same road, and how these are turned from the
    line of the first. `apart`: such pairs, and the radius of each agent."""
    pairs, radius = apart
    shape = radius.shape
    x, y = poses.x.reshape(shape), poses.y.reshape(shape)
    view = looks_ahead(world).reshape(shape)[:, :, None] + radius[:, None, :]
    near = pairs & (np.abs(x[:, None, :] - x[:, :, None]) < view)
    near &= np.abs(y[:, None, :] - y[:, :, None]) < view
    scene, first, second = np.nonzero(near)
    if not len(scene):
        return
    follower, leader = scene * world.slots + first, scene * world.slots + second
    found, along = nearest_in_corridor(world, follower, leader, Outlines.moving(world, poses))
    gap[scene, first, second] = found
    turned[scene, first, second] = poses.heading[leader] - along
