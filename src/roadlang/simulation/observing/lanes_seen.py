"""The lanes around all agents of a world at one time, from which some look up theirs."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from functools import cached_property

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...ir.surroundings import LaneChoice, LanePlaces
from ..lanes.road_lanes import LanesHere
from ..state.world import World


@dataclass
class LanesSeen:
    """What controllers ask for lane by lane: of all agents once, however many kinds of controllers
    there are. Valid until the world moves on."""

    world: World
    here: LanesHere
    _chosen: dict[str, Integers] = field(default_factory=dict)
    _columns: dict[str, Floats] = field(default_factory=dict)

    @cached_property
    def places(self) -> LanePlaces:
        """In which lanes all agents are."""
        world = self.world
        place = self.here.place(world.motion.offset)
        routed = world.has_route
        if routed.any():
            along = world.track.wrapped(world.motion.along)
            limit = world.table.speed_limit(slice(None), along)
            place.speed_limit[routed] = limit[routed]
        return place

    @cached_property
    def ends(self) -> Floats:
        """(N,) how far ahead of all agents their lane becomes too narrow to drive in."""
        return self.here.end(self.world.motion.offset)

    def place(self, rows: Integers) -> LanePlaces:
        """In which lanes some agents are."""
        return LanePlaces(*(getattr(self.places, name)[rows] for name in _PLACES))

    def of_lane(self, rows: Integers, which: LaneChoice | Floats, quantity: str) -> Floats:
        """(N,) a quantity of one lane of each of some agents, NaN where there is none."""
        offset = self.world.motion.offset
        if isinstance(which, str):
            if which not in self._chosen:
                self._chosen[which] = self.here.choose(which, offset)
            index = self._chosen[which][rows]
        else:
            index = self.here.numbered(which, rows)
        if quantity not in self._columns:
            self._columns[quantity] = getattr(self.here, quantity)
        return np.where(index >= 0, self._columns[quantity][rows, index], math.nan)


_PLACES = tuple(each.name for each in fields(LanePlaces))
