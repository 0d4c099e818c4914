"""What controllers ask of their surroundings one agent at a time."""

from __future__ import annotations

import math

import numpy as np

from roadlang import testing
from roadlang.ir.surroundings import LanePlace, LanePlaces, nearest_of, points_ahead


def test_points_ahead_are_columns_of_x_and_of_y() -> None:
    x, y = points_ahead(lambda ahead: (ahead, 10.0 * ahead, 0.5, 0.25), np.array([1.0, 3.0]))
    assert (x.tolist(), y.tolist()) == ([[1.0], [3.0]], [[10.0], [30.0]])


def test_the_nearest_others_come_in_order_of_their_distance() -> None:
    def placed(name: str, x: float, y: float) -> object:
        return testing.observation(agent=name, x=x, y=y, heading=x / 10.0, speed=x + y)

    ego = placed("ego", 0.0, 0.0)
    everyone = {
        "ego": ego, "far": placed("far", 9.0, 0.0), "beside": placed("beside", 3.0, 4.0),
        "near": placed("near", -1.0, 4.0),
    }  # fmt: skip
    x, y, heading, speed = nearest_of(ego, everyone, 2)  # type: ignore[arg-type]
    assert (x.tolist(), y.tolist()) == ([[-1.0, 3.0]], [[4.0, 4.0]])
    assert (heading.tolist(), speed.tolist()) == ([[-0.1, 0.3]], [[3.0, 7.0]])
    x, y, heading, speed = nearest_of(ego, everyone, 5)  # type: ignore[arg-type]
    assert x[0, :3].tolist() == [-1.0, 3.0, 9.0]
    for column in (x, y, heading, speed):
        assert column.shape == (1, 5)
        assert np.isnan(column[0, 3:]).all()


def test_an_agent_in_no_lane_has_no_limit_and_goes_along_its_road() -> None:
    nowhere = LanePlace()
    assert (nowhere.lane, nowhere.speed_limit, nowhere.road_direction) == (0, math.inf, 1.0)
    assert all(math.isnan(n) for n in (nowhere.offset, nowhere.width, nowhere.direction))


def test_the_place_of_one_agent_as_columns_and_back_is_the_same() -> None:
    place = LanePlace(-2, -5.25, 3.5, 13.9, 1.0, -1.0)
    columns = LanePlaces.of_single(place)
    assert columns.lane.dtype == np.int64
    assert columns.offset.tolist() == [-5.25]
    assert columns.road_direction.tolist() == [-1.0]
    assert columns.single(0) == place
