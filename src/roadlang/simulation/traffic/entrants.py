"""What of agents and the junctions that they cross does not change while they drive."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..junctions.crossings import Crossings
from ..junctions.signal_lights import Lights, ShownLights
from ..vehicles.bodies import Bodies
from .junction_tables import ALL_WAY_STOP, JunctionTables
from .meetings import Meetings
from .places import Places


@dataclass(frozen=True)
class Ways:
    """Arrays (N, X): the crossings of some agents, which are told apart from none."""

    rows: Any
    """an index of the agents: a slice where they are all agents, as that copies nothing"""
    crossings: Crossings
    bodies: Bodies
    """of all agents of the world"""
    none: Booleans
    number: Integers
    """of the connection, through all junctions; 0 for none"""
    lights: ShownLights
    half: Floats
    """(N, 1) half the lengths of the agents"""

    @classmethod
    def of(
        cls, rows: Any, crossings: Crossings, bodies: Bodies,
        tables: JunctionTables, lights: Lights,
    ) -> Ways:  # fmt: skip
        """Of the agents `rows`, whose crossings these are."""
        junction = crossings.junction
        none = junction < 0
        number = np.where(none, 0, tables.first[junction] + crossings.connection)
        half = 0.5 * bodies.length[rows, None]
        return cls(rows, crossings, bodies, none, number, lights.shown(number), half)


@dataclass(frozen=True)
class Entrants:
    """Agents whose junctions are looked at together: columns (N,), arrays (N, X) of crossings."""

    places: Places
    agents: Integers
    """columns of the world"""
    ways: Ways
    scene: Integers
    length: Floats
    size: Integers
    """number of the size, as `SweptConflicts` has them"""
    _latest: list[tuple[bytes, Meetings]] = field(default_factory=list)

    @classmethod
    def of(
        cls, places: Places, agents: Integers, ways: Ways, slots: int, size: Integers
    ) -> Entrants:  # fmt: skip
        """Of `agents`, in worlds of so many slots a scene; `size`: of all agents of the world."""
        length = ways.bodies.length[ways.rows]
        return cls(places, agents, ways, agents // slots, length, size[ways.rows])

    def holds(self, agents: Integers, bodies: Bodies) -> bool:
        """Whether it is still that of these agents of a world with these bodies."""
        return self.ways.bodies is bodies and np.array_equal(self.agents, agents)

    @cached_property
    def each(self) -> Integers:
        """(N,) their numbers."""
        return np.arange(len(self.agents))

    @cached_property
    def in_turn(self) -> Booleans:
        """(N, X) at junctions where all stop."""
        rule = self.places.tables.rule
        return np.asarray(rule[np.maximum(self.ways.crossings.junction, 0)] == ALL_WAY_STOP)

    @cached_property
    def must_stop(self) -> Booleans:
        """(N, X) at a stop sign."""
        return self.places.tables.must_stop[self.ways.number]

    @cached_property
    def is_short(self) -> Booleans:
        """(N, X) whether one asks late to go: at a stop sign, or where one yields."""
        return self.yields_any | self.must_stop

    @cached_property
    def yields_any(self) -> Booleans:
        """(N, X) to traffic of another connection."""
        return self.places.tables.yields_any[self.ways.number]

    def meetings(self, crossing: Booleans) -> Meetings:
        """Of the crossings (N, X) that are true: others only as agents come and go."""
        key = crossing.tobytes()
        if not self._latest or self._latest[0][0] != key:
            crossings, places = self.ways.crossings, self.places
            found = Meetings.of(
                crossing, crossings.junction, crossings.connection, self.scene, self.size,
                places.tables, places.conflicts,
            )  # fmt: skip
            self._latest[:] = [(key, found)]
        return self._latest[0][1]
