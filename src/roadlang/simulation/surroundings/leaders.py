"""Who is next ahead in the lane."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..vehicles.poses import Poses
from .corridors import nearest_in_corridor
from .leader_loops import can_search, search
from .near_pairs import near_pairs
from .next_on_road import next_on_road
from .outlines import Outlines
from .road_gaps import RoadColumns

MANY = 10_000
"""Pairs: of fewer, all gaps take less time than the order of the agents."""


@dataclass(frozen=True)
class Leaders:
    """Who is ahead of whom."""

    gap: Floats
    """(N,) to the next agent"""
    speed: Floats
    """(N,) speed of the vehicle ahead, along the lane"""
    acceleration: Floats
    """(N,) acceleration of the vehicle ahead, along the lane"""
    _gaps: Callable[[], Floats]
    _turned: Callable[[], Floats]

    @cached_property
    def gaps(self) -> Floats:
        """(S, A, A) from the first to the second along the line of the first, infinite for what is
        not in its lane ahead."""
        return self._gaps()

    @cached_property
    def turned(self) -> Floats:
        """(S, A, A) radians by which the second is turned from the line of the first."""
        return self._turned()

    def without(self, world: World, pairing: Pairing, ignored: Booleans) -> Leaders:
        """Who is ahead where some agents (N,) do not count."""
        gaps, turned = self.gaps, self.turned
        gaps = np.where(ignored.reshape(len(gaps), 1, -1), math.inf, gaps)
        return _next_ahead(world, pairing, gaps, turned)


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
        two = world.filled.reshape(shape)[:, :, None] & world.filled.reshape(shape)[:, None, :]
        apart = two & ~on_road & ~np.eye(shape[1], dtype=bool)
        against = (world.backward | world.closed) & world.filled
        one_way = not apart.any() and not against.any() and world.followed.guides.is_empty
        return cls(on_road, pairs & ~on_road, radius, scene, agent, one_way)

    one_way: bool
    """whether all of a scene go along one open road, in its direction"""

    @cached_property
    def exists(self) -> tuple[bool, bool]:
        """Whether there are pairs on one road, and others."""
        return bool(self.on_road.any()), bool(self.elsewhere.any())


def leaders(world: World, poses: Poses, pairing: Pairing) -> Leaders:
    """Who is ahead in the lane of each agent. Of two on one road their stations say it; what else
    is near is looked for along the line."""
    has_road_mates, has_others = pairing.exists
    if has_road_mates and not has_others:
        return _next_on_roads(world, poses, pairing)
    shape = (len(world.scenes), world.slots)
    if has_road_mates:
        gaps = RoadColumns.of(world).gaps(pairing.on_road)
    else:
        gaps = np.full((*shape, world.slots), math.inf)
    if has_others and can_search(world):
        return _searched(world, poses, pairing, gaps)
    turned = _turned(poses.heading.reshape(shape))
    if has_others:
        _search(world, poses, pairing, gaps, turned)
    return _next_ahead(world, pairing, gaps, turned)


def _next_on_roads(world: World, poses: Poses, pairing: Pairing) -> Leaders:
    """Where all that can be ahead are on the same roads."""
    columns, pairs, known = RoadColumns.of(world), pairing.on_road, None
    if pairing.one_way and pairs.size > MANY:
        least, first = next_on_road(columns)
    else:
        known, least, first = columns.least_gaps(pairs)
    heading = poses.heading.reshape(least.shape)
    agent = pairing.scene * world.slots + first
    return _ahead(
        world, (least, agent, poses.heading.take(agent) - heading),
        lambda: columns.gaps(pairs) if known is None else known, lambda: _turned(heading),
    )  # fmt: skip


def _turned(heading: Floats) -> Floats:
    """(S, A, A) from the headings (S, A) of the first to those of the second."""
    return heading[:, None, :] - heading[:, :, None]


def _next_ahead(world: World, pairing: Pairing, gaps: Floats, turned: Floats) -> Leaders:
    """The nearest of all that are ahead."""
    first = gaps.argmin(axis=2)
    agent = pairing.scene * world.slots + first
    place = (pairing.scene * world.slots + pairing.agent) * world.slots + first
    return _ahead(
        world, (gaps.take(place), agent, turned.take(place)), lambda: gaps, lambda: turned
    )


def _ahead(
    world: World,
    nearest: tuple[Floats, Integers, Floats],
    gaps: Callable[[], Floats],
    turned: Callable[[], Floats],
) -> Leaders:
    """`nearest`: the least gaps (S, A), to which agents of the world, and by how much these are
    turned; `gaps` and `turned`: of all pairs."""
    least, agent, turn = nearest
    along = np.where(np.isfinite(least), np.cos(turn), 0.0)
    speed = along * world.motion.speed.take(agent)
    acceleration = along * world.motion.acceleration.take(agent)
    return Leaders(least.ravel(), speed.ravel(), acceleration.ravel(), gaps, turned)


def _searched(world: World, poses: Poses, pairing: Pairing, gaps: Floats) -> Leaders:
    """The same by compiled loops. `gaps` (S, A, A): those of two on one road."""
    met = search(world, poses, pairing.elsewhere, pairing.radius, gaps)
    heading = along = poses.heading
    if len(met.heading):
        along = np.where(met.pair >= 0, met.heading[met.pair], heading)

    def all_turned() -> Floats:
        turned = _turned(heading.reshape(gaps.shape[:2]))
        place = met.agent * world.slots + met.target % world.slots
        turned.put(place, heading[met.target] - met.heading)
        return turned

    turn = heading.take(met.first) - along
    return _ahead(world, (met.least, met.first, turn), lambda: gaps, all_turned)


def _search(world: World, poses: Poses, pairing: Pairing, gap: Floats, turned: Floats) -> None:
    """Fill in the gaps to agents that are not on the same road, and how these are turned from the
    line of the first."""
    pairs = near_pairs(world, poses, pairing.elsewhere, pairing.radius)
    if not len(pairs.agent):
        return
    found, along = nearest_in_corridor(world, pairs, Outlines.moving(world, poses))
    place = pairs.agent * world.slots + pairs.target % world.slots
    gap.put(place, found)
    turned.put(place, poses.heading[pairs.target] - along)
