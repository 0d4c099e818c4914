"""The engine's records as a trace of the scene: station and cross-track error by its own curves."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import AgentTrace, Trace, with_pose_columns

from .layout import Layout
from .telemetry import Records, of_agent

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor


def trace_of(records: Records, layout: Layout, scene: Scene, step: float, engine: str) -> Trace:
    """The trace of a drive whose ticks last `step` seconds."""
    actors = {actor.name: actor for actor in scene.agents}
    agents: dict[str, AgentTrace] = {}
    time = np.zeros(0)
    for name, number in layout.agents.items():
        rows = of_agent(records, number)
        time = rows["tick"].astype(float) * step
        agents[name] = _agent(name, actors[name], rows, time, layout)
    for actor in scene.objects:
        agents[actor.name] = AgentTrace.still(actor, time)
    found = Trace(time=time, agents=agents, engine=engine, events=contact_events(agents))
    return with_pose_columns(found, scene)


def contact_events(agents: Mapping[str, AgentTrace]) -> tuple[Mapping[str, object], ...]:
    """When each agent began to touch something."""
    events = []
    for agent in agents.values():
        begun = np.flatnonzero(np.diff(np.minimum(agent.contacts, 1), prepend=0) > 0)
        events += [
            {"time": float(agent.time[i]), "event": "contact", "agent": agent.name} for i in begun
        ]
    return tuple(sorted(events, key=lambda event: (event["time"], event["agent"])))


def _agent(
    name: str, actor: SceneActor, rows: Records, time: np.ndarray, layout: Layout
) -> AgentTrace:
    speed = rows["speed"].astype(float)
    return AgentTrace(
        name=name,
        time=time,
        x=rows["x"].astype(float) + layout.frame.x,
        y=rows["y"].astype(float) + layout.frame.y,
        heading=np.unwrap(rows["heading"].astype(float)),
        speed=speed,
        acceleration=np.gradient(speed, time) if len(time) > 1 else np.zeros(len(time)),
        steering=rows["steering"].astype(float),
        station=rows["station"].astype(float),
        cross_track_error=rows["cross_track_error"].astype(float),
        progress=rows["progress"].astype(float),
        contacts=rows["contacts"].astype(float),
        present=np.ones(len(time)),
        length=actor.length,
        width=actor.width,
    )
