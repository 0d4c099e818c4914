"""A batch controller that is asked for one agent sees what that agent sees."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.observation import ObservationBatch
from roadlang.ir.surroundings import Neighbor, Neighbors

SEEN = testing.observation(
    station=10.0,
    cross_track_error=1.5,
    speed=7.0,
    speed_for_bends=lambda lateral, braking, on: 100.0 * lateral + 10.0 * braking + on,
    vehicle_ahead=lambda: (12.0, 3.0),
    acceleration_ahead=lambda: -1.5,
    obstacle_ahead=lambda: 8.0,
    lane_end=lambda: 55.0,
    offset_of_lane=lambda lane: -1.75 if lane == -1 else 9.0 if lane == "left" else 0.0,
    direction_of_lane=lambda lane: -1.0 if lane == 2 else 1.0,
    speed_limit_ahead=lambda braking, on: 10.0 * braking + on,
    stop_ahead=lambda: 21.0,
    right_of_way=lambda polite, bold: (polite, bold, polite + bold),
    junction_ahead=lambda: (5.0, 6.0, 7.0),
)


def test_what_is_asked_about_is_handed_on_and_answered_as_a_column() -> None:
    batch = ObservationBatch.of_single(SEEN)
    two, three, four = np.array([2.0]), np.array([3.0]), 4.0
    answers = {
        "line_ahead": (batch.line_ahead(two), (12.0, 0.0, 0.0, 0.0)),
        "curvatures_ahead": (batch.curvatures_ahead(two[None])[0], (0.0,)),
        "speed_for_bends": (batch.speed_for_bends(two, three, four), (234.0,)),
        "vehicle_ahead": (batch.vehicle_ahead(), (12.0, 3.0)),
        "acceleration_ahead": (batch.acceleration_ahead(), (-1.5,)),
        "obstacle_ahead": (batch.obstacle_ahead(), (8.0,)),
        "lane_end": (batch.lane_end(), (55.0,)),
        "offset_of_lane": (batch.offset_of_lane(np.array([-1.0])), (-1.75,)),
        "offset by word": (batch.offset_of_lane("left"), (9.0,)),
        "direction_of_lane": (batch.direction_of_lane(two), (-1.0,)),
        "speed_limit_ahead": (batch.speed_limit_ahead(two, three), (23.0,)),
        "stop_ahead": (batch.stop_ahead(), (21.0,)),
        "right_of_way": (batch.right_of_way(two, three), (2.0, 3.0, 5.0)),
        "junction_ahead": (batch.junction_ahead(), (5.0, 6.0, 7.0)),
    }
    for name, (found, expected) in answers.items():
        columns = found if isinstance(found, tuple) else (found,)
        assert [column.shape for column in columns] == [(1,)] * len(expected), name
        assert [column.item() for column in columns] == pytest.approx(list(expected)), name
    assert (batch.station.item(), batch.cross_track_error.item(), batch.speed.item()) == (
        10.0,
        1.5,
        7.0,
    )
    assert batch.agent.tolist() == ["ego"]
    assert batch.nearby(30.0) is not None


def test_neighbors_of_one_agent_are_the_same_as_columns() -> None:
    words = [("lead", "car"), ("bike", "bicycle"), ("late", "van")]
    seen = []
    for k, (name, kind) in enumerate(words):
        x = 10.0 * k
        place = (x, x + 1, x + 2, x + 3, x + 4, x + 5, x + 6, x + 7, x + 8, x + 9)
        seen.append(Neighbor(name, kind, *place, walks=k == 1))
    together = Neighbors.of_single(tuple(seen))
    assert together.single(0) == tuple(seen)
    assert together.name.tolist() == [["lead", "bike", "late"]]
    assert together.drift.tolist() == [[9.0, 19.0, 29.0]]
    assert together.walks.tolist() == [[False, True, False]]
    two = replace(together, there=np.array([[True, False, True]]))
    assert two.single(0) == (seen[0], seen[2])
