"""What agents see of the objects in their ways, and of the ways around these."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.surroundings import LanesBeside
from ..state.world import World
from ..surroundings.leaders import Leaders
from ..surroundings.oncoming_ways import comes_toward
from ..surroundings.touches_ahead import touches_ahead
from ..vehicles.poses import Poses
from .lanes_beside import lanes_beside
from .surroundings import Surroundings


class ObjectsSeen:
    """Of all agents of a world, as long as that stands still."""

    def __init__(self, world: World, poses: Poses, surroundings: Surroundings) -> None:
        self._world, self._poses, self._surroundings = world, poses, surroundings
        self._ahead: Floats | None = None

    def lines_moved(self) -> None:
        """Agents follow other lines from now on."""
        self._ahead = None

    def ahead(self, rows: Any, line: Floats | None = None) -> Floats:
        """(N,) gap to the next object in the way, infinite for none; of lines (N,), if given."""
        world = self._world
        obstacles = self._surroundings.in_the_way.obstacles(world, self._poses)
        if line is not None:
            return np.asarray(obstacles.ahead(world, self._every(rows, line))[rows])
        if self._ahead is None:
            self._ahead = obstacles.ahead(world)
        gap: Floats = self._ahead[rows]
        return gap

    def moving_ahead(self, rows: Integers, leaders: Leaders) -> Leaders:
        """The `leaders` without those agents that are stranded, as some agents see them: these
        count as objects from now on."""
        world, surroundings = self._world, self._surroundings

        def ahead(agents: Integers) -> Floats:
            return np.minimum(leaders.gap[agents], self.ahead(agents))

        right_of_way = surroundings.right_of_way(world)
        if surroundings.in_the_way.look(world, rows, ahead, right_of_way):
            self.lines_moved()
        stranded = surroundings.in_the_way.stranded
        if stranded is not None:
            leaders = leaders.without(world, surroundings.pairing(world), stranded)
        spare = surroundings.in_the_way.spare(leaders)
        return leaders if spare is None else replace(leaders, gap=leaders.gap - spare)

    def row(self, rows: Any, line: Floats, space: float) -> tuple[Floats, Floats, Floats]:
        """(N,) of the objects in the way of lines (N,): see `Obstacles`."""
        world = self._world
        obstacles = self._surroundings.in_the_way.obstacles(world, self._poses)
        found = obstacles.row_ahead(world, self._every(rows, line), space)
        return found[0][rows], found[1][rows], found[2][rows]

    def touched(
        self, path: Callable[..., Any], rows: Integers, leaves: Booleans, creeps: Booleans
    ) -> Floats:
        """(N,) for those of some agents that leave their lines: see `touches_ahead.py`. `path`:
        `View.path_ahead`."""
        out = np.full(len(rows), math.inf)
        chosen = rows[leaves]
        if len(chosen):
            ways = partial(path, chosen)
            standing = self._surroundings.in_the_way.stranded
            out[leaves] = touches_ahead(
                self._world, self._poses, chosen, ways, creeps[leaves], standing
            )
        return out

    def coming(self, rows: Integers, line: Floats, reach: Floats) -> Floats:
        """(N,) seconds until others come the other way on a stretch: see `oncoming_ways.py`. NaN
        asks for nothing."""
        out = np.full(len(rows), math.inf)
        asks = np.flatnonzero(np.isfinite(line + reach))
        if len(asks):
            stretch = line[asks], reach[asks]
            stops = self._surroundings.right_of_way(self._world).stops(self._world)
            ends = self.ahead(slice(None)), stops
            out[asks] = comes_toward(
                self._world,
                self._poses,
                rows[asks],
                stretch,
                ends,
                self._surroundings.in_the_way.stranded,
            )
        return out

    def lanes(self, rows: Integers, ahead: Floats, line: Floats) -> LanesBeside:
        """The lanes (N,) meters on, at lines (N,): see `lanes_beside.py`."""
        return lanes_beside(self._world, self._surroundings, rows, ahead, line)

    def _every(self, rows: Any, line: Floats) -> Floats:
        every: Floats = self._world.followed.lateral.offset.copy()
        every[rows] = line
        return every
