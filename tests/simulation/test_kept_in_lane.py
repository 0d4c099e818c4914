"""Cars in bends that are tight for the width of their lanes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.geometry.arrays import Floats
from roadlang.ir.scene import SceneRoad
from roadlang.simulation.kept_in_lane import kept_in_lane
from roadlang.simulation.leaning import LONG
from roadlang.simulation.route_lines import route_line

CORNER = '''
image plan from """
#####....
.....#...
......#..
.......#.
.......#.
.......#.
.......#.
""" {{ scale: 7m/px, legend: {{ "#": road }} }}
network town from plan {{
  extract with auto {{ width: {width}m }}
  lanes: 2, speed_limit: 30km/h
}}
agent ego is {kind} on town {{ route: [{route}], drive with traffic }}
'''
THERE, BACK = "(3m, 46m), (52m, 4m)", "(52m, 4m), (3m, 46m)"


@pytest.mark.parametrize(("kind", "width", "route"), [("car", 5.6, THERE), ("van", 6.2, BACK)])
def test_no_corner_of_a_car_leaves_its_lane_in_a_bend(kind: str, width: float, route: str) -> None:
    text = CORNER.format(kind=kind, route=route, width=width)
    (scene,) = testing.sample(text, 1)
    (road,) = scene.record.roads
    (agent,) = scene.record.agents
    drive = scene.run("builtin", duration=40.0)
    ego = drive.trace.agents["ego"]
    assert ego.progress[-1] > 0.98
    borders = road.cross_section().border_offsets(np.array(road.stations))
    assert agent.route is not None
    step = agent.route.steps[0]
    (place,) = (i for i, lane in enumerate(road.lane_list) if lane.id == step.lane)
    points = np.column_stack((road.x, road.y))
    for ahead, left in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        across = _offset(ego, 0.5 * ahead * agent.length, 0.5 * left * agent.width, road, points)
        assert across.max() < borders[place].max()
        assert across.min() > borders[place + 1].min()


def _offset(ego: Any, ahead: float, left: float, road: SceneRoad, points: Floats) -> Floats:
    """(n,) meters left of the road at which a point of the agent is."""
    cosine, sine = np.cos(ego.heading), np.sin(ego.heading)
    x = np.array(ego.x) + ahead * cosine - left * sine
    y = np.array(ego.y) + ahead * sine + left * cosine
    nearest = np.hypot(x[:, None] - points[:, 0], y[:, None] - points[:, 1]).argmin(axis=1)
    heading = np.array(road.heading)[nearest]
    dx, dy = x - points[nearest, 0], y - points[nearest, 1]
    return np.asarray(np.cos(heading) * dy - np.sin(heading) * dx)


def test_lines_stay_where_lanes_are_wide_and_for_long_vehicles() -> None:
    for kind, width, stays in (("car", 12.0, True), ("van", 5.6, False), ("bus", 5.6, True)):
        text = CORNER.format(kind=kind, route=THERE, width=width)
        scene = testing.sample(text, 1)[0].record
        (agent,) = scene.agents
        assert agent.route is not None
        line = route_line(agent.route, scene, {road.name: i for i, road in enumerate(scene.roads)})
        assert (kept_in_lane(line, agent) is line) == stays
        assert (agent.length > LONG) == (kind == "bus")
