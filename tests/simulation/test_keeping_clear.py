"""Long vehicles and what stands beside the bends of their routes."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.surroundings.obstacles import Obstacles

CORNER = '''
image plan from """
########
.......#
.......#
.......#
.......#
.......#
""" {{ scale: 14m/px, legend: {{ "#": road }} }}
network town from plan {{ lanes: 2, speed_limit: 50km/h }}
agent coach is {kind} on town {{ route: [(10m, 77m), (105m, 5m)], drive with traffic }}
object cone is cone at ({x}m, {y}m)
'''


@pytest.mark.parametrize(("x", "y"), [(106.0, 70.0), (101.0, 77.0), (107.0, 62.5)])
def test_a_bus_steers_around_a_cone_that_only_the_ground_beside_its_line_would_touch(
    x: float, y: float
) -> None:
    text = CORNER.format(kind="bus", x=x, y=y)
    scene = testing.sample(text, 1)
    (drive,) = scene.run("builtin", duration=40.0, control_step=0.1)
    assert not drive.trace.events
    assert drive.trace.agents["coach"].progress[-1] > 0.98


def test_a_thing_in_the_lane_still_stops_it() -> None:
    (scene,) = testing.sample(CORNER.format(kind="bus", x=103.2, y=50.0), 1)
    world = world_of([scene.record], {}, 0.02, 0.1)
    assert np.isfinite(Obstacles.of(world).ahead(world)[0])
