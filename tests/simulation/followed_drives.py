"""Drives as they look to who knows the poses alone."""

from __future__ import annotations

import numpy as np

from roadlang.ir.scene import Scene
from roadlang.ir.trace import Trace
from roadlang.simulation.mirroring import Mirror


def followed(trace: Trace, scene: Scene) -> Trace:
    """The trace that is made of the poses of a drive alone."""
    mirror = Mirror(scene, {}, float(trace.time[1] - trace.time[0]))
    agents = [trace.agents[actor.name] for actor in scene.agents]
    for i in range(len(trace.time)):
        pose = np.array([(one.x[i], one.y[i], one.heading[i], one.speed[i]) for one in agents])
        mirror.follow(pose, np.array([one.steering[i] for one in agents]), passed=i > 0)
        mirror.record()
    return mirror.trace("another engine")
