"""What stands in the lanes of agents: objects, and agents that are stranded."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..surroundings.leaders import Leaders
from ..surroundings.obstacles import Obstacles
from ..surroundings.stranded import SPARE, Reasons, Stranded
from ..traffic.right_of_way import RightOfWayGrants
from ..vehicles.poses import Poses


class InTheWay:
    """Of all agents of a world, found when it is first needed."""

    def __init__(self) -> None:
        self._obstacles: Obstacles | None = None
        self._stranded: Stranded | None = None
        self._all: tuple[bytes, Obstacles] | None = None

    def take(self, agents: Integers, scenes: Integers, count: int) -> None:
        """From now on the world has these of its `count` agents and of its scenes alone."""
        self._all = None
        if self._obstacles is not None:
            self._obstacles = self._obstacles.take(agents, count)
        if self._stranded is not None:
            self._stranded.take(agents, scenes)

    def obstacles(self, world: World, poses: Poses) -> Obstacles:
        """All that stands."""
        if self._obstacles is None:
            self._obstacles = Obstacles.of(world)
        standing = self.stranded
        if standing is None:
            return self._obstacles
        key = standing.tobytes()
        if self._all is None or self._all[0] != key:
            self._all = key, self._obstacles.with_agents(world, poses, standing)
        return self._all[1]

    @property
    def stranded(self) -> Booleans | None:
        """(N,) who was stranded when that was last looked at; None for nobody."""
        if self._stranded is None or not np.count_nonzero(self._stranded.agents):
            return None
        return self._stranded.agents

    def spare(self, leaders: Leaders) -> Floats | None:
        """(N,) meters more that agents keep to the `leaders`, so that they can pull out should
        these have broken down; None for nobody."""
        if self._stranded is None or not np.count_nonzero(self._stranded.suspects):
            return None
        count, slots = len(leaders.gaps), leaders.gaps.shape[1]
        first = leaders.gaps.argmin(axis=2) + np.arange(count)[:, None] * slots
        return np.where(self._stranded.suspects[first.ravel()], SPARE, 0.0)

    def look(
        self, world: World, rows: Integers, ahead: Callable[[Integers], Floats],
        right_of_way: RightOfWayGrants,
    ) -> bool:  # fmt: skip
        """Look who is stranded in the scenes of some agents. Whether others are than before.
        `ahead`: gaps to what is ahead of agents."""
        if self._stranded is None:
            self._stranded = Stranded(world)

        def reasons(agents: Integers) -> Reasons:
            to_line = right_of_way.junctions(world, agents)[0]
            return Reasons(ahead(agents), to_line)

        changes = self._stranded.look(world, rows, right_of_way.obeys, reasons)
        if changes:  # the same agents may stand somewhere else than before
            self._all = None
        return changes
