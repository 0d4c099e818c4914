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
from .junction_tables import RIGHT_FIRST, SIGNALS, JunctionTables
from .meetings import Meetings
from .rings import Rings
from .swept_conflicts import SweptConflicts
from .swept_paths import VehicleSize


@dataclass(frozen=True)
class Places:
    """The junctions of a world."""

    tables: JunctionTables
    lights: Lights
    rings: Rings
    by_right: Booleans
    """(J,) where who comes from the right goes first"""
    by_patience: Booleans
    """(J,) where who has waited long goes first: without signals, and not into a ring"""
    conflicts: SweptConflicts

    @classmethod
    def of(
        cls,
        junctions: Sequence[SceneJunction],
        scenes: Sequence[Scene],
        sizes: tuple[VehicleSize, ...],
    ) -> Places:
        """Of the junctions of some scenes, for vehicles of some sizes."""
        tables = JunctionTables.of(junctions)
        rounds = np.array([junction.kind == "roundabout" for junction in junctions], dtype=bool)
        by_right = (tables.rule == RIGHT_FIRST) & ~rounds
        lights, rings = Lights.of(junctions), Rings.of(junctions, scenes)
        by_patience = (tables.rule != SIGNALS) & ~rounds
        conflicts = SweptConflicts(junctions, sizes)
        return cls(tables, lights, rings, by_right, by_patience, conflicts)


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
    size: Integers
    """number of the size, as `SweptConflicts` has them"""
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
        places, crossings = self.places, self.crossings
        return Meetings.of(
            crossing, crossings.junction, crossings.connection, self.scene, self.size,
            places.tables, places.conflicts,
        )  # fmt: skip

    def of_mates(self, values: Floats) -> Floats:
        """(N, A) a column of the others of the scene of each."""
        slots = self.gaps.shape[1]
        return np.asarray(np.repeat(values.reshape(-1, slots), slots, axis=0))
