"""What of a drive is computed once for all its agents."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..lanes.road_lanes import LanesHere, RoadLanes, lane_values
from ..lanes.speed_zones import any_limit
from ..state.world import World
from ..surroundings.leaders import Pairing
from ..surroundings.neighbors import Nearby
from ..surroundings.standing_objects import StandingObjects
from ..traffic.right_of_way import RightOfWayGrants
from ..vehicles.poses import Poses
from .bend_speeds import BendSpeeds
from .in_the_way import InTheWay
from .lane_endings import has_lane_endings
from .road_places import are_backward, stations_at


class Surroundings:
    """What of a drive is computed once, when it is first needed: plans of speeds before bends, the
    lanes of the roads, where objects are along the lines."""

    def __init__(self, world: World) -> None:
        self.bends = BendSpeeds(world)
        self._roads = [road for scene in world.scenes for road in scene.roads]
        counts = [len(scene.roads) for scene in world.scenes]
        self._first = np.concatenate([[0], np.cumsum(counts)])[:-1].astype(np.int64)
        self.has_limits = any_limit(self._roads)
        """of speed, on any road"""
        self.has_lane_endings = has_lane_endings(self._roads)
        self._lanes: RoadLanes | None = None
        self._objects: StandingObjects | None = None
        self.in_the_way = InTheWay()
        self._right_of_way: RightOfWayGrants | None = None
        self._pairing: Pairing | None = None

    def take(self, agents: Integers, count: int, slots: int) -> None:
        """From now on the world has these of its `count` agents alone."""
        self.bends.take(agents)
        scenes = agents[::slots] // slots
        self._first, self._pairing = self._first[scenes], None
        self.in_the_way.take(agents, scenes, count)
        if self._right_of_way is not None:
            self._right_of_way.take(agents, scenes)

    def carry_on(self, before: Surroundings) -> None:
        """Junctions are granted as they were: nothing has changed that they depend on."""
        self._right_of_way = before._right_of_way

    def pairing(self, world: World) -> Pairing:
        """Who of a scene can be ahead of whom."""
        if self._pairing is None:
            self._pairing = Pairing.of(world)
        return self._pairing

    def right_of_way(self, world: World) -> RightOfWayGrants:
        """At the junctions."""
        if self._right_of_way is None:
            self._right_of_way = RightOfWayGrants(world)
        return self._right_of_way

    def lanes(self, world: World, ahead: Floats | None = None) -> LanesHere:
        """Of all agents, where they are, or (N,) meters on; on connections there are none."""
        if self._lanes is None:
            self._lanes = RoadLanes(self._roads)
        first = np.repeat(self._first, world.slots)
        along = world.motion.along if ahead is None else world.motion.along + ahead
        along = along if ahead is None else world.track.wrapped(along)
        place = world.table.place(slice(None), along)
        road = np.where((place.road >= 0) & (place.turn < 0), first + place.road, -1)
        lanes = self._lanes.at(road, stations_at(world, along), are_backward(world, along))
        rows = np.flatnonzero(world.has_route)
        if not len(rows):
            return lanes
        # The reference line of a route is the middle of its lane, not that of the road.
        middle = lane_values(lanes.middles[rows], lanes.numbered(place.lane[rows], rows))
        shift = np.zeros(len(road))
        shift[rows] = np.where(np.isfinite(middle), middle, 0.0)
        return replace(lanes, borders=lanes.borders - shift[:, None])

    def nearby(self, world: World, poses: Poses) -> Nearby:
        """Of all agents."""
        if self._objects is None:
            self._objects = StandingObjects.of(world)
        return Nearby(world, poses, self._objects)
