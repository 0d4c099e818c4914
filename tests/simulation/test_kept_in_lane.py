"""Cars in bends that are tight for the width of their lanes."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import pytest

from roadlang import testing
from roadlang.geometry.arrays import Floats
from roadlang.geometry.curves.bend_room import LONG
from roadlang.ir.scene import SceneRoad
from roadlang.simulation.bends.kept_in_lane import kept_in_lane
from roadlang.simulation.lines.line_sources import LineSource
from roadlang.simulation.lines.route_lines import LineLeg, RouteLine, route_line

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
    drive = scene.run("builtin", duration=40.0, control_step=0.1)
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


def test_before_a_bend_to_the_other_side_a_car_keeps_in_the_lane_that_it_leaves() -> None:
    """Out of a roundabout: left round its ring, then right into the exit, which is a junction."""
    scene = testing.sample(CORNER.format(kind="van", width=6.2, route=THERE), 1)[0].record
    (van,) = scene.agents
    ring, exit_ = 30.0, 8.0
    s = np.arange(0.0, ring + exit_ + 20.0, 0.25)
    bend = np.where(s < ring, 1.0 / 18.0, np.where(s < ring + exit_, -1.0 / 5.6, 0.0))
    heading = np.cumsum(bend) * 0.25
    x, y = np.cumsum(np.cos(heading)) * 0.25, np.cumsum(np.sin(heading)) * 0.25
    source = LineSource(s, x, y, heading, 3.2)
    legs = [
        LineLeg(0, 0, lane, begin, s[:2], s[:2], 10.0, turn)
        for lane, begin, turn in ((-1, 0.0, None), (0, ring, cast(Any, "a junction")))
    ]
    moved = kept_in_lane(RouteLine(source, tuple(legs)), van).source
    left = np.cos(heading) * (moved.y - y) - np.sin(heading) * (moved.x - x)
    room = 1.6 - 1.49  # half of the lane, and what the van covers to its right in the ring
    assert left[s < ring - 2.0].min() > -room
    assert left[s < ring - 10.0].max() > 0.05
    assert left[(s > ring + 1.0) & (s < ring + exit_)].max() < -0.1
