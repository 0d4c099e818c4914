"""Objects in traces: on disk a trace holds what moves, and the scene what stands."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..ir.road_heights import standing_trace
from ..ir.scene import Scene
from ..ir.trace import AgentTrace, Trace


def without_objects(trace: Trace, scene: Scene) -> Trace:
    """The trace without the objects of the scene that stand in one place throughout."""
    objects = {object_.name for object_ in scene.standing}
    moving = {
        name: agent
        for name, agent in trace.agents.items()
        if name not in objects or not _is_object(agent)
    }
    return replace(trace, agents=moving)


def with_objects(trace: Trace, scene: Scene) -> Trace:
    """The trace with all objects of the scene: those that it lacks stand where they were placed."""
    missing = {
        object_.name: standing_trace(scene, object_, trace.time)
        for object_ in scene.standing
        if object_.name not in trace.agents
    }
    return replace(trace, agents={**trace.agents, **missing})


def _is_object(agent: AgentTrace) -> bool:
    poses = np.stack([agent.x, agent.y, agent.heading])
    return bool((poses == poses[:, :1]).all())
