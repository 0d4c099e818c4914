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
from .road_gaps import gaps_on_roads


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
    has_road_mates, has_others = pairing.exists
    if has_road_mates:
        gap = gaps_on_roads(world, pairing.on_road)
    else:
        gap = np.full((*shape, world.slots), math.inf)
    heading = poses.heading.reshape(shape)
    turned = heading[:, None, :] - heading[:, :, None]
    if has_others:
        both = there[:, :, None] & there[:, None, :]
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
