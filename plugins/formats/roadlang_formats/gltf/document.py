"""A scene, still or driven, as the bytes of a binary glTF file."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

import roadlang
from roadlang.geometry import Floats

from ..surfaces.heights import SceneHeights
from .glb import GlbWriter
from .scene_nodes import Collision, SceneNodes

if TYPE_CHECKING:
    from roadlang.api import Scene, Trace


def document(scene: Scene, collision: Collision, trace: Trace | None = None) -> bytes:
    """The file of a scene; with a trace, agents move as they were driven."""
    writer = GlbWriter(f"roadlang {roadlang.__version__}")
    nodes = SceneNodes(scene, writer, collision)
    nodes.write()
    if trace is not None:
        _animate(scene, trace, nodes)
    return writer.content({"title": scene.title or scene.name, "scene": scene.index})


def _animate(scene: Scene, trace: Trace, nodes: SceneNodes) -> None:
    heights = SceneHeights.of(scene)
    poses: dict[int, tuple[Floats, Floats]] = {}
    times = None
    for agent in trace.agents.values():
        if agent.name in nodes.agents and len(agent.time):
            times = agent.time - agent.time[0]
            flat = np.column_stack((agent.x, agent.y))
            places = np.column_stack((flat, heights.at(flat)))
            poses[nodes.agents[agent.name]] = places, np.unwrap(agent.heading)
    if times is not None:
        nodes.writer.animation("drive", times, poses)
