"""Agents at random begin where they can follow their lane."""

from __future__ import annotations

import numpy as np

from roadlang import testing

BLOCK = """
image plan from \"\"\"
####
#..#
####
\"\"\" { scale: 8m/px, legend: { "#": road } }
network town from plan { lanes: 2 }
"""


def test_no_car_begins_in_a_bend_that_it_cannot_steer_through() -> None:
    agents = "agent cars is car on town at random { count: 3, drive with traffic }"
    for scene in testing.sample(BLOCK + agents, 40, seed=5):
        (road,) = scene.record.roads
        stations, heading = np.array(road.stations), np.unwrap(road.heading)
        for car in scene.record.agents:
            assert car.start is not None
            assert car.offset is not None
            around = np.interp([car.start - 1.0, car.start + 1.0], stations, heading)
            bend = float(np.diff(around)[0]) / 2.0
            assert abs(bend / (1.0 - bend * car.offset)) < 0.27


def test_where_there_is_nothing_else_it_begins_in_a_tight_bend() -> None:
    bus = "agent bus is bus on town at random { drive with traffic }"
    assert len(testing.sample(BLOCK.replace("8m/px", "5m/px") + bus, 3)) == 3
