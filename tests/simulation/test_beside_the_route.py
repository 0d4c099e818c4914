"""Routes from a sidewalk or a bike lane: beside the lanes of the route, through junctions too."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing

TOWN = """
image plan from \"\"\"
...#.....
...#.....
#########
\"\"\" { scale: 20m/px, legend: { "#": road } }
network town from plan {
  left: [drive(3.25m), bike(1.5m), sidewalk(2m)]
  right: [drive(3.25m), bike(1.5m), sidewalk(2m)]
}
"""
EAST, WEST = 10.0 - 4.0, 10.0 + 4.0
"""Meters north of the two bike lanes of the road that goes on."""


@pytest.mark.parametrize("drives", ["lane_follow", "traffic", "pure_pursuit"])
def test_bicycles_keep_to_the_line_of_their_lane(drives: str) -> None:
    text = f"""{TOWN}
    agent east is bicycle on town at (20m, 7m) {{
      lane: bike, route: [(150m, 7m)], drive with {drives} {{ speed: 6m/s }} }}
    agent west is bicycle on town at (120m, 13m) {{
      lane: bike, route: [(70m, 50m)], drive with {drives} {{ speed: 6m/s }} }}
    """
    ((one,)) = testing.sample(text, 1).run("builtin", duration=15.0)
    east, west = one.trace.agents["east"], one.trace.agents["west"]
    assert east.y == pytest.approx(np.full(len(east.y), EAST), abs=0.2)
    assert east.x[-1] > 100.0
    assert west.y[0] == pytest.approx(WEST, abs=0.1)
    assert west.x[-1] == pytest.approx(74.0, abs=0.3)
    assert west.y[-1] > 40.0


@pytest.mark.parametrize(("y", "side"), [(4.0, -1.0), (16.0, 1.0)])
@pytest.mark.parametrize("lane", ["sidewalk", "bike"])
def test_a_point_stands_for_the_lane_on_its_side(y: float, side: float, lane: str) -> None:
    kind = "bicycle" if lane == "bike" else "pedestrian"
    text = f"{TOWN}\nagent ego is {kind} on town at (30m, {y}m) {{ lane: {lane} }}"
    (scene,) = testing.sample(text, 1)
    assert np.sign(scene.record.agents[0].y - 10.0) == side
