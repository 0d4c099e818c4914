"""Routes from a sidewalk or a bike lane: beside the lanes of the route, through junctions too."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import Scene

from .driven_roads import drive_together
from .routed_scenes import drive_scenes

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


def test_bicycles_keep_to_the_line_of_their_lane() -> None:
    kinds = ("lane_follow", "traffic", "pure_pursuit")
    texts = [
        f"""{TOWN}
        agent east is bicycle on town at (20m, 7m) {{
          lane: bike, route: [(150m, 7m)], drive with {drives} {{ speed: 6m/s }} }}
        agent west is bicycle on town at (120m, 13m) {{
          lane: bike, route: [(70m, 50m)], drive with {drives} {{ speed: 6m/s }} }}
        """
        for drives in kinds
    ]
    for drives, trace in zip(kinds, drive_together(texts, duration=15.0), strict=True):
        east, west = trace.agents["east"], trace.agents["west"]
        assert east.y == pytest.approx(np.full(len(east.y), EAST), abs=0.2), drives
        assert east.x[-1] > 100.0, drives
        assert west.y[0] == pytest.approx(WEST, abs=0.1), drives
        assert west.x[-1] == pytest.approx(74.0, abs=0.3), drives
        assert west.y[-1] > 40.0, drives


@pytest.mark.parametrize(("y", "side"), [(4.0, -1.0), (16.0, 1.0)])
@pytest.mark.parametrize("lane", ["sidewalk", "bike"])
def test_a_point_stands_for_the_lane_on_its_side(y: float, side: float, lane: str) -> None:
    kind = "bicycle" if lane == "bike" else "pedestrian"
    text = f"{TOWN}\nagent ego is {kind} on town at (30m, {y}m) {{ lane: {lane} }}"
    (scene,) = testing.sample(text, 1)
    assert np.sign(scene.record.agents[0].y - 10.0) == side


CROSSING = """
image plan from \"\"\"
....#....
....#....
....#....
....#....
#########
....#....
....#....
....#....
....#....
\"\"\" { scale: 30m/px, legend: { "#": road } }
network town from plan {
  left: [drive, bike, sidewalk]
  right: [drive, bike, sidewalk]
  speed_limit: 30km/h
  control with CONTROL
}
agent ego is car on town at (137m, 20m..40m) { route: TURN, drive with traffic }
agent rider is bicycle on town at (PLACE) {
  lane: bike, route: straight, drive with traffic { speed: 16km/h..20km/h } }
"""
ALONGSIDE, ONCOMING = "139m, 45m..75m", "131m, 205m..225m"


TURNS = (
    ("right", ALONGSIDE, "yield"),
    ("right", ALONGSIDE, "signals { green: 15s }"),
    ("left", ONCOMING, "right_first"),
    ("left", ONCOMING, "signals { green: 15s }"),
)


def test_who_turns_lets_riders_in_the_bike_lane_go_straight_on() -> None:
    scenes: list[Scene] = []
    for turn, place, control in TURNS:
        text = CROSSING.replace("CONTROL", control).replace("TURN", turn).replace("PLACE", place)
        scenes += [scene.record for scene in testing.sample(text, 3, seed=3)]
    traces = drive_scenes(scenes, duration=60.0)
    for number, case in enumerate(TURNS):
        close = 0
        for trace in traces[3 * number : 3 * number + 3]:
            ego, rider = trace.agents["ego"], trace.agents["rider"]
            apart = np.hypot(ego.x - rider.x, ego.y - rider.y)
            close += apart.min() < 15.0
            assert not ego.contacts.any(), case
            assert not rider.contacts.any(), case
            assert abs(ego.x[-1] - 135.0) > 40.0, case
            if "signals" not in case[2]:
                assert rider.speed[np.abs(rider.y - 135.0) < 30.0].min() > 2.0, case
        assert close, case
