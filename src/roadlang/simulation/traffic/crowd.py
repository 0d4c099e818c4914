"""The agents of the scenes whose junctions are looked at, with what right of way needs of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import Scene
from ...ir.scene_junctions import SceneJunction
from ..crossings import Crossings
from ..signal_lights import Lights
from .approaches import Approaches
from .grants import Grants
from .junction_tables import RIGHT_FIRST, JunctionTables
from .meetings import Meetings
from .rings import Rings


@dataclass(frozen=True)
class Places:
    """The junctions of a world."""

    tables: JunctionTables
    lights: Lights
    rings: Rings
    by_right: Booleans
    """(J,) where who comes from the right goes first"""

    @classmethod
    def of(cls, junctions: Sequence[SceneJunction], scenes: Sequence[Scene]) -> Places:
        """Of the junctions of some scenes."""
        tables = JunctionTables.of(junctions)
        rounds = np.array([junction.kind == "roundabout" for junction in junctions], dtype=bool)
        by_right = (tables.rule == RIGHT_FIRST) & ~rounds
        return cls(tables, Lights.of(junctions), Rings.of(junctions, scenes), by_right)


@dataclass(frozen=True)
class Crowd:
    """Columns (N,) of agents, arrays (N, X) of their crossings, (N, A) of others in the scene."""

    places: Places
    time: float
    crossings: Crossings
    near: Approaches
    grants: Grants
    """changed by whoever lets agents go"""
    scene: Integers
    speed: Floats
    length: Floats
    present: Booleans
    """else it has left"""
    is_moving: Booleans
    obeys: Booleans
    politeness: Floats
    aggression: Floats
    gaps: Floats
    """(N, A) along the line to each other of the scene"""
    oncoming: Floats
    """meters to where one waits for who comes toward it in a narrow place, infinite for no need"""

    @property
    def held(self) -> Booleans:
        """(N, X) which crossings agents may cross."""
        return np.asarray(np.isfinite(self.grants.order))

    def meetings(self, crossing: Booleans) -> Meetings:
        """Of the crossings (N, X) that are true."""
        tables = self.places.tables
        parts = (self.crossings.junction, self.crossings.connection)
        return Meetings.of(crossing, *parts, self.scene, tables)

    def of_mates(self, values: Floats) -> Floats:
        """(N, A) a column of the others of the scene of each."""
        slots = self.gaps.shape[1]
        return np.asarray(np.repeat(values.reshape(-1, slots), slots, axis=0))
