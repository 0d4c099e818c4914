"""The routes of agents through a network: thin lines with an arrow where they end."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import palette
from .markup import element, group, path_data, title

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor
    from roadlang.geometry import Floats

    from .viewport import Viewport

_MOST_COLORS = 6
_BESIDE = 0.35
"""Meters between the routes of two agents that lead along one lane"""
_SPREAD = 5


def agent_routes(scene: Scene, viewport: Viewport, size: float) -> str:
    """One line for each agent that has a route, side by side where several share a lane."""
    routed = [agent for agent in scene.agents if agent.route is not None]
    lines = [_route(scene, agent, index, viewport, size) for index, agent in enumerate(routed)]
    return group(lines, class_="agent-routes", fill="none", stroke_linejoin="round")


def _route(scene: Scene, agent: SceneActor, index: int, viewport: Viewport, size: float) -> str:
    import numpy as np

    from roadlang.api import route_points

    assert agent.route is not None
    x, y, heading, _ = route_points(scene, agent.route)
    away = _BESIDE * ((index + _SPREAD // 2) % _SPREAD - _SPREAD // 2)
    points = np.stack([x - away * np.sin(heading), y + away * np.cos(heading)], axis=-1)
    color = palette.agent_color(index % _MOST_COLORS)
    line = viewport.place(points)
    width = max(0.12 * size, 1.0)
    return element(
        "g",
        title(f"route of {agent.name}"),
        element("path", d=path_data(line), stroke_width=width, stroke_dasharray="none"),
        "" if agent.route.closed else _arrow(line, 0.55 * size),
        stroke=color,
        stroke_opacity=0.85,
    )


def _arrow(line: Floats, size: float) -> str:
    """Two strokes at the end of a line."""
    import numpy as np

    back = line[-1] - line[:-1]
    far = np.flatnonzero(np.hypot(back[:, 0], back[:, 1]) > 0.5)
    if not len(far):
        return ""
    ahead = back[far[-1]] / np.hypot(*back[far[-1]])
    left = np.array([-ahead[1], ahead[0]])
    ends = [line[-1] - size * ahead + side * 0.5 * size * left for side in (1.0, -1.0)]
    head = np.array([ends[0], line[-1], ends[1]])
    return element("path", d=path_data(head), stroke_width=max(0.14 * size, 1.2))
