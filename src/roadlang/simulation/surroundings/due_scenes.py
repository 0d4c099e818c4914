"""Scenes of a world that are looked at from time to time, each when it is due."""

from __future__ import annotations

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..state.world import World
from .sorted_groups import sorted_groups

_ROUNDING = 1e-6
"""Seconds."""


def due_scenes(
    world: World, rows: Integers, looked: Floats, interval: float
) -> tuple[Integers, Integers]:
    """Which scenes of some agents are due, and all agents of these. `looked`: (S,) when each was
    looked at last."""
    if len(looked) == 1:
        is_due = bool(world.time - looked[0] > interval - _ROUNDING)
        return _ONE[:is_due], np.arange(len(world.present) if is_due else 0)
    scenes = sorted_groups(rows // world.slots)[0]
    scenes = scenes[world.time - looked[scenes] > interval - _ROUNDING]
    agents = scenes[:, None] * world.slots + np.arange(world.slots)
    return scenes, np.asarray(agents.ravel())


_ONE = np.zeros(1, dtype=np.int64)
