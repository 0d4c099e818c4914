"""What is known of all agents of a world now: the columns of traces, and of `when:`."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from ...geometry.arrays import Floats
from ..state.world import World
from ..surroundings.levels import ground_heights
from ..vehicles.poses import Poses

Column = Callable[[World, Poses], Floats]

COLUMNS: Mapping[str, Column] = {
    "x": lambda world, poses: poses.x,
    "y": lambda world, poses: poses.y,
    "heading": lambda world, poses: poses.heading,
    "speed": lambda world, poses: world.motion.speed,
    "acceleration": lambda world, poses: world.motion.acceleration,
    "steering": lambda world, poses: np.arctan(world.motion.tangent),
    "station": lambda world, poses: world.station,
    "cross_track_error": lambda world, poses: world.cross_track_error,
    "progress": lambda world, poses: world.progress,
    "contacts": lambda world, poses: world.contacts,
    "route_progress": lambda world, poses: world.traveled,
    "red_light": lambda world, poses: world.red_lights,
    "collision": lambda world, poses: world.collision,
    "present": lambda world, poses: world.present.astype(np.float64),
    "elevation": lambda world, poses: ground_heights(world),
    "along": lambda world, poses: world.motion.along,
    "offset": lambda world, poses: world.motion.offset,
    "length": lambda world, poses: world.bodies.length,
    "width": lambda world, poses: world.bodies.width,
}
"""(N,) by the names of the members of `AgentTrace`; `along` and `offset` are of the lines."""
