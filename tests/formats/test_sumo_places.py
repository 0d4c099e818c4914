"""Along which parts of roads agents of SUMO go."""

from __future__ import annotations

from dataclasses import replace

import pytest

from roadlang import testing
from roadlang.api import RoadPart, Scene
from roadlang_formats.sumo.places import RoadSpan, places_of

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] }, lanes: 2 }
agent ego is car on main at 30m { lane: LANE }
"""
ALONG = (RoadPart("a", 0.0, 40.0), RoadPart("b", 90.0, 60.0), RoadPart("c", 10.0, 40.0))
"""100 m: with `a`, against `b`, with `c`."""


def placed(lane: int, start: float, along: tuple[RoadPart, ...] = ()) -> list[RoadSpan]:
    scene: Scene = testing.sample(TEXT.replace("LANE", str(lane)))[0].record
    (road,), (agent,) = scene.roads, scene.agents
    scene = replace(scene, roads=(replace(road, along=along, derived=not along),))
    return places_of(scene, replace(agent, start=start))


@pytest.mark.parametrize(
    ("lane", "start", "spans"),
    [
        (-1, 0.0, [("a", 0, 40, False), ("b", 90, 60, True), ("c", 10, 40, False)]),
        (-1, 30.0, [("a", 30, 40, False), ("b", 90, 60, True), ("c", 10, 40, False)]),
        (-1, 50.0, [("b", 80, 60, True), ("c", 10, 40, False)]),
        (-1, 70.0, [("c", 10, 40, False)]),
        (1, 100.0, [("c", 40, 10, True), ("b", 60, 90, False), ("a", 40, 0, True)]),
        (1, 50.0, [("b", 80, 90, False), ("a", 40, 0, True)]),
        (1, 40.0, [("a", 40, 0, True)]),
    ],
)
def test_a_road_that_runs_over_others_is_their_parts(
    lane: int, start: float, spans: list[tuple[str, float, float, bool]]
) -> None:
    assert placed(lane, start, ALONG) == [RoadSpan(*span) for span in spans]


def test_a_road_of_its_own_goes_on_to_the_end_that_it_is_driven_to() -> None:
    assert placed(-1, 30.0) == [RoadSpan("main", 30.0, 100.0, False)]
    assert placed(1, 30.0) == [RoadSpan("main", 30.0, 0.0, True)]
