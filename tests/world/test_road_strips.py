"""Roads as rectangles between their stations: what stands in their lanes is measured by these."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from roadlang.evaluate.candidates import CandidateBatch
from roadlang.geometry import Footprints
from roadlang.judging.acceptance import Acceptance
from roadlang.world.placement.road_strips import RoadStrips, depth_in_lanes, road_strips
from tests.straight_road import STRAIGHT

RING = """
road ring {
  draw with segments { pieces: [straight(60m), arc(30m, 180deg), straight(60m), arc(30m, 180deg)] }
  closed: true, width: 6m
}
"""
SWAYING = STRAIGHT.replace("main {", "first {") + (
    "road main from first { perturb with sine { amplitude: 1m..3m, wavelength: 80m } }\n"
)


def strips(acceptance: Acceptance, count: int) -> RoadStrips:
    batch = CandidateBatch(acceptance.scenario, 0, np.zeros(count, np.int64), np.arange(count))
    (found,) = road_strips(batch, False)
    return found


@pytest.mark.parametrize(
    ("text", "length", "width", "period"),
    [(STRAIGHT, 200.0, 8.0, np.inf), (RING, 120.0 + 60.0 * np.pi, 6.0, 120.0 + 60.0 * np.pi)],
)
def test_the_rectangles_of_a_road_are_as_long_and_as_wide_as_it_is(
    acceptance: Callable[[str], Acceptance], text: str, length: float, width: float, period: float
) -> None:
    found = strips(acceptance(text), 3)
    assert found.boxes.length.sum() == pytest.approx(length, rel=1e-3)
    assert found.boxes.width == pytest.approx(width)
    assert found.periods == pytest.approx((period,), rel=1e-3)
    assert not found.group.any(), "all candidates share them"
    ends = np.cumsum(found.boxes.length)
    assert found.station == pytest.approx(ends - 0.5 * found.boxes.length)
    nearest = np.hypot(found.boxes.x - 50.0, found.boxes.y).argmin()
    assert abs(found.boxes.heading[nearest]) < 0.2


def test_each_candidate_has_rectangles_of_its_own_where_the_road_is_drawn(
    acceptance: Callable[[str], Acceptance],
) -> None:
    found = strips(acceptance(SWAYING), 3)
    assert set(found.group.tolist()) == {0, 1, 2}
    assert found.boxes.width == pytest.approx(8.0)
    highest = [np.abs(found.boxes.y[found.group == number]).max() for number in range(3)]
    assert len(set(highest)) == 3


CROSSED = (
    STRAIGHT
    + "road other { draw with waypoints { points: [(50m, -90m), (50m, 90m)] } width: 6m }\n"
)


@pytest.mark.parametrize(
    ("text", "x", "y", "road", "start", "depth"),
    [
        (STRAIGHT, 30.0, 5.5, None, 0.0, 0.0),
        (STRAIGHT, 30.0, 4.6, None, 0.0, 0.4),
        (STRAIGHT, 30.0, 4.6, "other", 30.0, 0.4),
        (STRAIGHT, 30.0, 4.6, "main", 30.0, 0.0),
        (STRAIGHT, 30.0, 4.6, "main", 40.0, 0.4),
        (STRAIGHT, 199.0, 4.6, "main", 1.0, 0.4),
        (CROSSED, 30.0, 4.6, "main", 30.0, 0.0),
        (CROSSED, 53.5, 9.0, "main", 53.5, 0.5),
        (CROSSED, 53.5, 9.0, "other", 99.0, 0.0),
        (RING, 0.0, -3.5, "ring", 3.0, 0.0),
        (RING, 0.0, -3.5, "ring", 120.0 + 60.0 * np.pi - 1.0, 0.0),
        (RING, 0.0, -3.5, "ring", 90.0, 0.5),
    ],
)
def test_what_stands_in_lanes_does_so_by_its_depth_save_right_beside_where_it_stands(
    acceptance: Callable[[str], Acceptance],
    text: str,
    x: float,
    y: float,
    road: str | None,
    start: float,
    depth: float,
) -> None:
    """A box of 2 m by 2 m. At the seam of a closed road, both ends are right beside it."""
    place = [np.array([value]) for value in (x, y, 0.0, 2.0, 2.0)]
    scenario = acceptance(text).scenario
    batch = CandidateBatch(scenario, 0, np.zeros(1, np.int64), np.zeros(1, np.int64))
    rows = np.zeros(1, np.int64)
    found = depth_in_lanes(Footprints(*place), rows, [road], np.array([start]), batch, False)
    assert found == pytest.approx([depth], abs=1e-6)
