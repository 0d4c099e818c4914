"""The junctions of a world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans
from ...ir.scene import Scene
from ...ir.scene_junctions import SceneJunction
from ..junctions.signal_lights import Lights
from .junction_tables import RIGHT_FIRST, SIGNALS, JunctionTables
from .rings import Rings
from .swept_conflicts import SweptConflicts
from .swept_paths import VehicleSize


@dataclass(frozen=True)
class Places:
    """J junctions."""

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
