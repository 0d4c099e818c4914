"""Crosswalks: where they lie, how wide they are, and that nothing keeps clear of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from roadlang.ir.scene import Scene, SceneActor
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]
STREET = """
road street {
  draw with segments { pieces: [straight(200m)] }
  left: [drive(3m), sidewalk(2m)], right: [drive(3m), bike(1.5m), parking(2m), sidewalk(2m)]
}
"""
TOWN = '''
image plan from """
....#....
#########
....#....
""" { scale: 25m/px, legend: { "#": road } }
network town from plan { lanes: 2, sidewalks: 2m }
'''


def scene_of(sample: Sample, text: str, **more: Any) -> Scene:
    (scene,) = sample(text, **more).scenes
    return scene


def marking(sample: Sample, statement: str, road: str = STREET) -> SceneActor:
    scene = scene_of(sample, road + statement)
    assert scene.objects == ()
    (found,) = scene.markings
    return found


def test_it_reaches_from_curb_to_curb(sample: Sample) -> None:
    """The driving lanes are 6 m about the middle; a bike and a parking lane lie to their right."""
    found = marking(sample, "object zebra is crosswalk on street at 80m")
    assert (found.x, found.heading, found.length) == (80.0, 0.0, 4.0)
    assert found.width == pytest.approx(3 + 3 + 1.5 + 2)
    assert found.y == pytest.approx((3.0 - 6.5) / 2)
    assert (found.height, found.lane, found.category) == (0.0, None, "crosswalk")


def test_without_a_curb_it_reaches_over_the_lanes_that_somebody_uses(sample: Sample) -> None:
    road = STREET.replace(", sidewalk(2m)", "").replace("parking(2m)", "shoulder(2m)")
    found = marking(sample, "object zebra is crosswalk on street at 80m", road)
    assert found.width == pytest.approx(3 + 3 + 1.5)


@pytest.mark.parametrize(
    ("options", "width", "y"),
    [
        ("width: 5m", 5.0, 0.0),
        ("lane: bike", 1.5, -3.75),
        ("lane: bike, width: 2m", 2.0, -3.75),
        ("offset: 1m", 9.5, -0.75),
    ],
)
def test_width_and_lane_may_be_said(sample: Sample, options: str, width: float, y: float) -> None:
    found = marking(sample, f"object zebra is crosswalk on street at 80m {{ {options} }}")
    assert [found.width, found.y] == pytest.approx([width, y])


def test_where_the_middle_moves_it_moves_along(sample: Sample) -> None:
    """The parts of a joined road keep the line between lanes; two lanes more lie to its right."""
    roads = """
    road one { draw with segments { pieces: [straight(100m)] }, lanes: 2, oneway: true, width: 7m }
    road two { draw with segments { pieces: [straight(200m)] }, lanes: 4, oneway: true, width: 14m }
    road both from one { then: two, taper: 20m }
    """
    found = marking(sample, "object zebra is crosswalk on both at 250m", roads)
    assert [found.width, found.y] == pytest.approx([14.0, -3.5])


def test_beside_another_it_still_spans_the_road(sample: Sample) -> None:
    text = "agent ego is car on street at 50m\nobject zebra is crosswalk at ahead_of(ego, 10m)"
    found = marking(sample, text)
    assert [found.x, found.y] == pytest.approx([50 + 2.25 + 10 + 2, -1.75])


def test_without_a_road_it_is_as_wide_as_two_lanes(sample: Sample) -> None:
    found = marking(sample, "object zebra is crosswalk at (5m, 60m) { heading: 90deg }")
    assert (found.x, found.y, found.width) == (5.0, 60.0, 7.0)


@pytest.mark.parametrize("side", ["left", "right"])
def test_who_is_beside_it_stands_at_the_curb(sample: Sample, side: str) -> None:
    text = f"""
    object zebra is crosswalk on street at 80m
    agent walker is pedestrian at beside(zebra, {side}) {{ drive with crossing }}
    """
    (walker,) = scene_of(sample, STREET + text).agents
    curb = 3.0 if side == "left" else -6.5
    away = 1.0 + walker.width / 2
    assert [walker.x, walker.y] == pytest.approx([80.0, curb + (away if curb > 0 else -away)])


def test_nothing_keeps_clear_of_it(sample: Sample) -> None:
    """Agents and objects stand on it, also those that are drawn and keep away from all."""
    text = """
    object zebra is crosswalk on street at 15m { apart: 5m, count: 2 }
    agent cars is car on street at 12m..18m { apart: 2m }
    object cone is cone on street at 15m { offset: 2.5m }
    """
    scene = scene_of(sample, STREET + text)
    assert [thing.name for thing in scene.markings] == ["zebra[0]", "zebra[1]"]
    assert [thing.name for thing in scene.standing] == ["cone", "zebra[0]", "zebra[1]"]


def test_formulas_measure_it(sample: Sample) -> None:
    text = """
    object zebra is crosswalk on street at 20m..180m
    agent ego is car on street at 10m
    require far: distance(ego, zebra) > 100m
    require before: zebra.start < 150m
    """
    scene = scene_of(sample, STREET + text)
    assert 110 < (scene.markings[0].start or 0.0) < 150


@pytest.mark.parametrize("where", ["(25m, 37m)", "junction(near: (112m, 37m), before: 8m)"])
def test_in_a_network_it_spans_its_road(sample: Sample, where: str) -> None:
    scene = scene_of(sample, TOWN + f"object zebra is crosswalk on town at {where}")
    (zebra,) = scene.markings
    road = next(road for road in scene.roads if road.name == zebra.road)
    assert zebra.start is not None
    assert zebra.offset == pytest.approx(0.0)
    assert zebra.width == pytest.approx(road.width[0])


def test_a_row_of_people_stands_beside_it_in_a_network(sample: Sample) -> None:
    """Before, a row beside what is in no lane stood in one place."""
    text = """
    object zebra is crosswalk on town at (50m, 37m)
    agent people is child at beside(zebra, right) { count: 3, spacing: 1.2m, drive with crossing }
    """
    people = scene_of(sample, TOWN + text).agents
    starts = [person.start or 0.0 for person in people]
    assert starts == pytest.approx([starts[0], starts[0] + 1.2, starts[0] + 2.4])


def test_a_legend_draws_paint_too(sample: Sample) -> None:
    text = TOWN.replace('"#": road }', '"#": road, "z": crosswalk }').replace(
        "....#....\n#####", ".z..#....\n#####"
    )
    scene = scene_of(sample, text)
    assert scene.objects == ()
    (found,) = scene.markings
    assert (found.name, found.category, found.height) == ("town/crosswalk[0]", "crosswalk", 0.0)
