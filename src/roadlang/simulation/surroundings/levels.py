"""Who and what is on the same level: agents on different levels do not touch, see or yield.

The one rule is `are_apart`. Here it is asked of agents where they are, and of places along their
lines. On level ground (`World.heights` is None) all are on one level, and nothing is computed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ...geometry.areas.levels import are_apart
from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.road_heights import object_heights
from ...ir.scene import Scene, SceneActor
from ..state.world import World


def ground_heights(world: World) -> Floats:
    """(N,) meters of the ground below all agents; NaN on level ground, and on no road."""
    if world.heights is None:
        return np.full(len(world.present), math.nan)
    return world.heights.at(world.track, world.motion.along)


def standing_heights(scenes: Sequence[Scene]) -> Floats:
    """(K,) meters of all objects of some scenes, in their order."""
    found = [height for scene in scenes for height in object_heights(scene, scene.objects)]
    return np.array(found, dtype=np.float64)


def apart_where_met(
    world: World, agents: Integers, ahead: Floats, height: Floats | float
) -> Booleans:
    """Whether what is `ahead` of agents along their lines, at a height, is on another level than
    the line there: it is not in their way. `ahead` may be infinite or NaN, for nothing."""
    there = np.where(np.isfinite(ahead), ahead, 0.0)
    return apart_at(world, agents, world.motion.along[agents] + there, height)


def apart_at(world: World, agents: Integers, along: Floats, height: Floats | float) -> Booleans:
    """Whether the lines of agents are on another level, at arc lengths, than a height."""
    assert world.heights is not None
    return are_apart(world.heights.at(world.track.of_rows(agents), along), height)


def on_level_of_line(world: World, row: int, objects: Sequence[SceneActor]) -> Booleans:
    """(K,) which objects of the scene of a line are on its level where it comes nearest to them."""
    if world.heights is None:
        return np.ones(len(objects), dtype=bool)
    x, y = (np.array([getattr(actor, name) for actor in objects], dtype=float) for name in "xy")
    scene = world.scenes[int(np.flatnonzero(world.track.row == row)[0]) // world.slots]
    return are_on_level_of_line(world, row, (x, y), np.array(object_heights(scene, objects)))


def are_on_level_of_line(
    world: World, row: int, places: tuple[Floats, Floats], heights: Floats
) -> Booleans:
    """(K,) which places at heights are on the level of a line where it comes nearest to them."""
    assert world.heights is not None
    lines = world.track.lines
    first = row * lines.cells
    cells = slice(first, first + int(lines.last[row]) + 1)
    off_x, off_y = places[0][:, None] - lines.x[cells], places[1][:, None] - lines.y[cells]
    nearest = first + (off_x * off_x + off_y * off_y).argmin(axis=1)
    return ~are_apart(world.heights.cells[nearest], heights)
