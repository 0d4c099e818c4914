"""Where agents and objects stand."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import roadlang
from roadlang.diagnostics import DiagnosticError
from roadlang.evaluate.candidates import CandidateBatch
from roadlang.ir.scene import SceneActor
from roadlang.plugins.discovery import load_registry
from roadlang.scenes.sampling import SamplingResult
from roadlang.world.index import index_scenario
from roadlang.world.placement.copies import kinds_of
from roadlang.world.placement.placement import least_spacing
from roadlang.world.placement_faults import DEFAULT_APART
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]


def placed(sample: Sample, text: str, **more: Any) -> dict[str, SceneActor]:
    (scene,) = sample(STRAIGHT + text, **more).scenes
    return {thing.name: thing for thing in (*scene.agents, *scene.objects)}


def start_of(thing: SceneActor) -> float:
    assert thing.start is not None
    return thing.start


@pytest.mark.parametrize(
    ("where", "x", "y"),
    [
        ("at 20m", 20, -2),
        ("at 50%", 100, -2),
        ("at 20m { lane: none }", 20, 0),
        ("at 20m { facing: back }", 20, 2),
        ("at 20m { offset: 0.5m }", 20, -1.5),
        ("at 20m { lane: none, offset: 1.5m }", 20, 1.5),
        ("at 20m { lane: -1 }", 20, -2),
        ("at 20m { lane: 1, offset: 0.5m }", 20, 2.5),
        ("at 20m { side: left, offset: 1m }", 20, 4 + 1 + 0.9),
        ("at 20m { side: right }", 20, -4 - 0.9),
    ],
)
def test_a_car_stands_where_it_is_put(sample: Sample, where: str, x: float, y: float) -> None:
    car = placed(sample, f"agent ego is car on main {where}")["ego"]
    assert car.x == pytest.approx(x)
    assert car.y == pytest.approx(y, abs=1e-9)


LANES = (
    "road main {\n  draw with waypoints { points: [(0m, 0m), (200m, 0m)] }\n"
    "  left: [drive(3m), bike(1m), parking(2m), sidewalk(2m)]\n"
    "  right: [bus(3m), drive(3m), drive(3m), sidewalk(2m)]\n}\n"
)


@pytest.mark.parametrize(
    ("options", "lane"),
    [
        ("", -2),
        ("facing: back", 1),
        ("lane: outer", -3),
        ("lane: outer, facing: back", 1),
        ("lane: bus", -1),
        ("lane: parking", 3),
        ("lane: sidewalk", -4),
        ("lane: sidewalk, facing: back", 4),
        ("lane: sidewalk, side: left", 4),
        ("lane: drive, side: right", -2),
        ("lane: outer, side: left", 1),
        ("lane: drive, side: left, facing: forward", 1),
        ("lane: none, side: right", None),
        ("lane: none", None),
        ("side: right", None),
    ],
)
def test_a_lane_may_be_named(sample: Sample, options: str, lane: int | None) -> None:
    (scene,) = sample(LANES + f"agent ego is bicycle on main at 9m {{ {options} }}").scenes
    assert scene.agents[0].lane == lane


@pytest.mark.parametrize(
    ("traffic", "options", "lane"),
    [("left", "", 1), ("left", "facing: back", -1), ("right", "", -1)],
)
def test_an_agent_is_on_the_side_that_traffic_keeps(
    sample: Sample, traffic: str, options: str, lane: int
) -> None:
    text = f"world {{ traffic: {traffic} }}\nagent ego is car on main at 9m {{ {options} }}\n"
    (scene,) = sample(STRAIGHT + text).scenes
    assert scene.agents[0].lane == lane
    assert math.cos(scene.agents[0].heading) == pytest.approx(-1 if options else 1)


def test_a_lane_drawn_among_words_differs_by_copy(sample: Sample) -> None:
    text = "agent cars is car on main at 0%..100% { count: 9, lane: choice(outer, none) }\n"
    things = placed(sample, text)
    assert {car.lane for car in things.values()} == {-1, None}


@pytest.mark.parametrize("kinds", ["choice(parking, outer)", "choice(outer, parking)"])
def test_a_lane_is_drawn_among_kinds_and_words(sample: Sample, kinds: str) -> None:
    street = "road main { draw with segments { pieces: [straight(200m)] }, left: [drive(3m)], "
    street += "right: [drive(3m), parking(2m)] }\n"
    text = f"agent cars is car on main at 0%..100% {{ count: 9, lane: {kinds} }}\n"
    (scene,) = sample(street + text).scenes
    assert {car.lane for car in scene.agents} == {-1, -2}


@pytest.mark.parametrize("side", ["", ", side: left"])
def test_a_kind_of_lane_that_is_not_there_is_refused(sample: Sample, side: str) -> None:
    with pytest.raises(DiagnosticError) as caught:
        sample(STRAIGHT + f"agent ego is car on main at 3m {{ lane: parking{side} }}\n")
    assert caught.value.diagnostics[0].code == "RL613"
    assert "1 (drive), -1 (drive)" in caught.value.diagnostics[0].help[0]


@pytest.mark.parametrize(
    ("options", "degrees"),
    [
        ("", 0),
        ("facing: back", 180),
        ("lane: 1", 180),
        ("lane: 1, facing: forward", 0),
        ("heading: 30deg", 30),
    ],
)
def test_a_car_points_the_way_of_its_lane(sample: Sample, options: str, degrees: float) -> None:
    car = placed(sample, f"agent ego is car on main at 9m {{ {options} }}")["ego"]
    assert math.cos(car.heading - math.radians(degrees)) == pytest.approx(1)


@pytest.mark.parametrize(
    ("options", "degrees"),
    [
        ("lane: parking", 180),
        ("lane: parking, side: left", 180),
        ("lane: parking, facing: forward", 0),
    ],
)
def test_a_parked_car_points_the_way_of_the_traffic_beside_it(
    sample: Sample, options: str, degrees: float
) -> None:
    (scene,) = sample(LANES + f"object van is parked_van on main at 9m {{ {options} }}").scenes
    assert scene.objects[0].lane == 3
    assert math.cos(scene.objects[0].heading - math.radians(degrees)) == pytest.approx(1)


def test_without_a_road_a_point_of_the_world_is_meant(sample: Sample) -> None:
    kiosk = placed(sample, "object kiosk is building at (40m, 32m) { heading: 30deg }")["kiosk"]
    assert (kiosk.x, kiosk.y) == (40, 32)
    assert kiosk.heading == pytest.approx(math.pi / 6)
    assert kiosk.road is None


def test_one_may_be_placed_from_another(sample: Sample) -> None:
    things = placed(
        sample,
        "agent ego is car on main at 20m\nagent lead is car on main at ego.start + (10m..30m)\n"
        "require apart: lead.start - ego.start > 25m\n",
    )
    assert 45 < start_of(things["lead"]) < 50


def test_each_copy_of_a_group_has_draws_of_its_own(sample: Sample) -> None:
    things = placed(sample, "object trees is tree on main at 0%..100% { count: 6, offset: 2m..8m }")
    assert list(things) == [f"trees[{i}]" for i in range(6)]
    assert len({thing.x for thing in things.values()}) == 6
    assert len({thing.y for thing in things.values()}) == 6


def test_a_formula_holds_for_each_copy(sample: Sample) -> None:
    text = "agent cars is car on main at 0%..100% { count: 3 }\nrequire far: cars.start > 100m\n"
    for seed in range(3):
        assert all(start_of(car) > 100 for car in placed(sample, text, seed=seed).values())


def test_the_number_of_copies_may_be_drawn(sample: Sample) -> None:
    text = (
        STRAIGHT + "agent cars is choice(car, truck) on main at 0%..100% { count: integer(0, 3) }\n"
    )
    scenes = sample(text, 30).scenes
    assert {len(scene.agents) for scene in scenes} == {0, 1, 2, 3}
    assert {car.kind for scene in scenes for car in scene.agents} == {"car", "truck"}


def test_who_would_stand_beyond_the_end_is_placed_again(sample: Sample) -> None:
    result = sample(STRAIGHT + "agent ego is car on main at 150m..300m\n", 10)
    assert all(150 <= start_of(scene.agents[0]) <= 200 - 2.25 for scene in result.scenes)
    assert result.candidates == 10


def test_who_stands_by_a_param_beyond_the_end_is_drawn_again_with_all_else(sample: Sample) -> None:
    text = STRAIGHT + "param where = 150m..300m\nagent ego is car on main at where\n"
    result = sample(text, 10)
    assert all(150 <= start_of(scene.agents[0]) <= 200 for scene in result.scenes)
    assert any("begins on" in row.text for row in result.table)


def test_beyond_the_end_for_certain_is_impossible(sample: Sample) -> None:
    bent = "road bent from main { perturb with bump { at: 50m, height: 1m, length: 20m } }\n"
    assert sample(STRAIGHT + bent + "agent ego is car on bent at 300m\n").impossible == (
        "`ego` begins on `bent`",
    )


def test_beyond_the_end_of_a_road_without_draws_is_an_error(sample: Sample) -> None:
    with pytest.raises(DiagnosticError, match="RL615"):
        sample(STRAIGHT + "agent ego is car on main at 300m\n")


def test_a_lane_that_is_not_there_is_refused(sample: Sample) -> None:
    with pytest.raises(DiagnosticError) as caught:
        sample(STRAIGHT + "agent ego is car on main at 3m { lane: 2 }\n")
    assert caught.value.diagnostics[0].code == "RL613"
    assert "-1" in caught.value.diagnostics[0].help[0]


def test_the_least_spacing_is_that_of_the_longest_copies_of_all_candidates() -> None:
    text = STRAIGHT + (
        "agent row is car on main at 20m { count: 2, length: 3m..9m, lane: -1 }\n"
        "agent kept is car on main at 190m..200m { count: 2, length: 4m, apart: 3m, lane: -1 }\n"
    )
    scenario = index_scenario(roadlang.loads(text).scenario, load_registry())
    candidates = CandidateBatch(scenario, 0, np.zeros(20, np.int64), np.arange(20))
    row, kept = (scenario.actors[name] for name in ("row", "kept"))
    longest = kinds_of(row, candidates).lengths.max()
    assert 8.0 < longest < 9.0
    assert least_spacing(row, candidates) == longest + DEFAULT_APART
    assert least_spacing(kept, candidates) == 4.0 + 3.0
