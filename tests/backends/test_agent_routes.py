"""Routes in figures and in Godot: the lines that agents follow."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from roadlang.api import Scene, route_points
from roadlang.scenes.sampling import SamplingResult
from roadlang_godot.build.layout import layout_of
from roadlang_standard.svg.drawing import Style, draw
from tests.world.test_routes import DRIVES, agent, town

Sample = Callable[..., SamplingResult]
AGENTS = f"""
agent ego is car on town {{ route: [(10m, 45m), (85m, 15m)], {DRIVES} }}
agent still is car on town at (100m, 45m)
"""


def scene_of(sample: Sample) -> Scene:
    (scene,) = sample(town() + AGENTS).scenes
    return scene


def test_the_line_of_a_route_begins_at_the_agent_and_has_no_gap(sample: Sample) -> None:
    scene = scene_of(sample)
    ego = agent(scene)
    assert ego.route is not None
    x, y, heading, width = route_points(scene, ego.route)
    assert np.hypot(x[0] - ego.x, y[0] - ego.y) < 0.01
    steps = np.hypot(np.diff(x), np.diff(y))
    assert steps.max() < 1.5
    turns = np.abs(np.remainder(np.diff(heading) + np.pi, 2.0 * np.pi) - np.pi)
    assert turns.max() < 0.3
    assert (width > 2.0).all()


def test_a_figure_shows_the_route_of_an_agent_with_an_arrow(sample: Sample) -> None:
    figure = draw(scene_of(sample), Style())
    (routes,) = re.findall(r'<g class="agent-routes".*?</g>\n</g>', figure, re.DOTALL)
    assert "route of ego" in routes
    assert "still" not in routes
    line, arrow = re.findall(r'd="M([^"]*)"', routes)
    assert len(line.split("L")) > 30
    assert len(arrow.split("L")) == 3
    assert arrow.split("L")[1] == line.split("L")[-1]


def test_godot_gets_the_route_as_path_and_the_road_of_who_has_none(sample: Sample) -> None:
    scene = scene_of(sample)
    layout = layout_of(scene)
    assert set(layout.paths) == {"the route of ego", agent(scene, "still").road}
