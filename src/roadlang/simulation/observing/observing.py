"""What controllers see: columns over agents of a world."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.observation import ObservationBatch
from ...ir.readings import Reading, Readings
from ...ir.surroundings import LaneChoice, LanePlaces, Neighbors
from ..state.along_routes import limits_ahead
from ..state.world import World
from ..surroundings.leaders import Leaders, leaders
from ..surroundings.neighbors import Nearby
from ..tapes.traced import TracedColumn
from ..vehicles import compiled
from ..vehicles.path_calls import FEWEST
from ..vehicles.poses import Poses, frames_ahead, line_frames, points_beside
from ..vehicles.vehicle_steps import MOST
from .lane_changes import zipper
from .lane_endings import lets_in
from .lanes_seen import LanesSeen
from .lazy_observations import LazyObservations
from .objects_seen import ObjectsSeen
from .sensing import Sensing
from .surroundings import Surroundings

_NOTHING: Mapping[str, Floats] = {}
_NO_READINGS = Readings({})
BEFORE_OBJECTS = 3.0
"""Meters before an object at which agents stand: from there they can pull out."""


@dataclass
class View:
    """A world as it is at one time, seen by its agents."""

    world: World
    poses: Poses
    step: float
    surroundings: Surroundings
    sensing: Sensing | None = None
    """what agents have sensed; None: they see the truth"""
    _ahead: Leaders | None = field(default=None)
    _lanes: LanesSeen | None = field(default=None)
    _nearby: Nearby | None = field(default=None)

    @cached_property
    def objects(self) -> ObjectsSeen:
        """What agents see of objects, and of the ways around them."""
        return ObjectsSeen(self.world, self.poses, self.surroundings)

    def of(self, chosen: Integers) -> ObservationBatch:
        """What some agents see."""
        return LazyObservations(self, chosen)

    def line_ahead(
        self, rows: Any, distance: Floats | float
    ) -> tuple[Floats, Floats, Floats, Floats]:
        """(N,) x, y, heading and curvature of the lines to follow, a distance on."""
        world = self.world
        if self.sensing is not None:
            distance = distance + self._lead(rows)
        track = world.track.of_rows(rows)
        along = track.wrapped(world.motion.along[rows] + distance)
        x, y, heading, curvature, _ = line_frames(track, along)
        speed = world.motion.speed[rows]
        offset, slope, bend, moving = world.followed.ahead(rows, distance, speed, along)
        if np.count_nonzero(offset):
            x = x - np.sin(heading) * offset
            y = y + np.cos(heading) * offset
        if moving is not None:
            heading = np.where(moving, heading + np.arctan(slope), heading)
            curvature = np.where(moving, curvature + bend, curvature)
        return x, y, heading, curvature

    def curvatures_ahead(self, rows: Any, distances: Floats) -> Floats:
        """(K, N) curvatures of the lines to follow, some distances (K, N) on: those of
        `line_ahead`."""
        world = self.world
        if self.sensing is not None:
            distances = distances + self._lead(rows)
        track = world.track.of_rows(rows)
        along = track.wrapped(world.motion.along[rows] + distances)
        if isinstance(along, TracedColumn):
            curvature: Floats = along.line_frames(track)[3]
        elif compiled.is_loaded():
            curvature = frames_ahead(track, along)[1][3]
        else:
            cell, _ = track.cell(along)
            curvature = track.lines.seen_curvature[cell]  # `take` would copy all cells
        speed = world.motion.speed[rows]
        _, _, bend, moving = world.followed.ahead(rows, distances, speed, along)
        return curvature if moving is None else np.where(moving, curvature + bend, curvature)

    def path_ahead(self, rows: Any, distances: Floats) -> tuple[Floats, Floats]:
        """(K, N) x and y of the lines to follow, some distances (K,) on. The same points as those
        of `line_ahead`, but for rounding and `(curvature * cell)^2 / 8` of the offset."""
        world, distances = self.world, distances[:, None]
        if self.sensing is not None:
            distances = distances + self._lead(rows)
        track = world.track.of_rows(rows)
        along = track.wrapped(world.motion.along[rows] + distances)
        left = world.followed.ahead(rows, distances, world.motion.speed[rows], along)[0]
        return points_beside(track, along, left)

    def path_seen(
        self, rows: Any, distances: tuple[float, ...], places: Sequence[Floats]
    ) -> Floats | None:
        """(2 K, N) the points of `path_ahead`, meters ahead and to the left by turns, of agents of
        whom x, y, cosine and sine of the heading are `places`. The same memory every time. None
        where it takes less time to find with new arrays, or the lines are not open and at rest."""
        world = self.world
        is_plain = not (world.track.has_closed or world.followed.guided or compiled.is_loaded())
        if self.sensing is not None or not is_plain or not FEWEST <= len(places[0]) <= MOST:
            return None
        along, speed = world.motion.along[rows], world.motion.speed[rows]
        left, _, _, moving = world.followed.ahead(rows, 0.0, speed, along)
        paths = None if moving is not None else world.track.paths(rows, distances)
        return None if paths is None else paths.seen((along, left, *places))

    @property
    def replaced(self) -> Mapping[str, Floats]:
        """(N,) by name: columns that agents see in place of the true ones, where they are not
        NaN."""
        return _NOTHING if self.sensing is None else self.sensing.replaced

    def _lead(self, rows: Any) -> Floats | float:
        """(N,) how far ahead of where they are agents see themselves along their lines."""
        seen = self.replaced.get("traveled")
        if seen is None:
            return 0.0
        lead = seen[rows] - self.world.traveled[rows]
        return np.where(np.isnan(lead), 0.0, lead)

    def vehicle_ahead(self, rows: Any) -> tuple[Floats, Floats]:
        """(N,) gap to the next agent in the lane, and its speed along it."""
        ahead = self._leaders()
        return ahead.gap[rows], ahead.speed[rows]

    def moving_ahead(self, rows: Integers) -> tuple[Floats, Floats, Floats]:
        """(N,) gap to the next agent in the lane that is not stranded, its speed and its
        acceleration along the lane."""
        ahead = self.objects.moving_ahead(rows, self._leaders())
        return ahead.gap[rows], ahead.speed[rows], ahead.acceleration[rows]

    def acceleration_ahead(self, rows: Any) -> Floats:
        """(N,) that of `vehicle_ahead` along the lane, 0 where there is none."""
        found: Floats = self._leaders().acceleration[rows]
        return found

    def lines_moved(self) -> None:
        """Agents follow other lines from now on."""
        self.objects.lines_moved()

    def lane_end(self, rows: Integers) -> Floats:
        """(N,) how far ahead of agents their lane becomes too narrow to drive in."""
        return np.asarray(self._current_lanes().ends[rows])

    def right_of_way(
        self, rows: Integers, temper: tuple[Floats | float, Floats | float] | None = None,
        passing: Booleans | None = None,
    ) -> tuple[Floats, Floats, Floats]:  # fmt: skip
        """(N,) where agents have to stop, and the gap to whom they follow where lanes merge, and
        its speed. Those that are `passing` objects do not stop for them."""
        world, surroundings = self.world, self.surroundings
        right_of_way = surroundings.right_of_way(world)
        objects = partial(self.objects.ahead, slice(None))
        stop, gap, speed = right_of_way.ahead(
            world, self.poses, self._leaders(), rows, objects, temper
        )
        if world.table.has_changes:
            changes = zipper(world)
            sooner = changes[0][rows] < gap
            gap = np.where(sooner, changes[0][rows], gap)
            speed = np.where(sooner, changes[1][rows], speed)
            stop = np.minimum(stop, changes[2][rows])
        if surroundings.has_lane_endings and temper is not None:
            lanes, ahead = self._current_lanes().here, self._leaders()
            merging, pace = lets_in(world, lanes, ahead, rows, temper[0])
            gap, speed = np.minimum(gap, merging), np.where(merging < gap, pace, speed)
        standing = self.objects.ahead(rows) - BEFORE_OBJECTS
        standing = standing if passing is None else np.where(passing, math.inf, standing)
        stop = np.minimum(stop, standing)
        return np.minimum(stop, right_of_way.pedestrians(world, self.poses, rows)), gap, speed

    def junction_ahead(self, rows: Integers) -> tuple[Floats, Floats, Floats]:
        """(N,) meters to the next junctions, from there to their ends, and seconds until red."""
        return self.surroundings.right_of_way(self.world).junctions(self.world, rows)

    def _leaders(self) -> Leaders:
        if self._ahead is None:
            pairing = self.surroundings.pairing(self.world)
            self._ahead = leaders(self.world, self.poses, pairing)
        return self._ahead

    def lane_place(self, rows: Integers) -> LanePlaces:
        """In which lanes agents are."""
        return self._current_lanes().place(rows)

    def speed_limit_ahead(
        self, rows: Integers, braking: Floats | float, on: Floats | float
    ) -> Floats:
        """(N,) the greatest speeds from which the limits ahead can be obeyed."""
        if not self.surroundings.has_limits:
            return np.full(len(rows), math.inf)
        along = self.world.track.wrapped(self.world.motion.along)[rows]
        ahead = limits_ahead(self.world.table, rows, along, braking, on)
        routed = self.world.has_route[rows]
        if np.count_nonzero(routed) == len(routed):
            return ahead
        limit = self.lane_place(rows).speed_limit
        # Without a route the table knows the lane of the start, and with it the zones ahead.
        zoned = self.world.table.has_several_legs(rows)
        return np.where(routed, ahead, np.where(zoned, np.minimum(ahead, limit), limit))

    def of_lane(self, rows: Integers, which: LaneChoice | Floats, quantity: str) -> Floats:
        """(N,) a quantity of one lane of each agent, NaN where there is none."""
        return self._current_lanes().of_lane(rows, which, quantity)

    def readings(self, rows: Integers) -> Mapping[str, Reading]:
        """What some agents have got from their sensors."""
        return _NO_READINGS if self.sensing is None else self.sensing.readings(rows)

    def nearby(self, rows: Integers, distance: float) -> Neighbors:
        """Who and what is within a distance of agents."""
        if self._nearby is None:
            self._nearby = self.surroundings.nearby(self.world, self.poses)
        return self._nearby.of(rows, distance)

    def _current_lanes(self) -> LanesSeen:
        if self._lanes is None:
            self._lanes = LanesSeen(self.world, self.surroundings.lanes(self.world))
        return self._lanes
