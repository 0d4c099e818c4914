"""Values and roads in forms that are seldom written, by hand."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.ir.scene import Scene
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]


def scene(sample: Sample, text: str, seed: int = 0) -> Scene:
    return sample(text, seed=seed).scenes[0]


@pytest.mark.parametrize(
    ("value", "meters"),
    [("-(3m)", -3), ("-(1m + 2m)", -3), ("abs(-3m)", 3), ("abs(2m - 5m)", 3), ("2m ^ 2 / 1m", 4),
     ("min(4m, 2m, 3m)", 2), ("max(4m, 2m, 3m)", 4), ("10m / 4", 2.5), ("3m - -1m", 4),
     ("10m - 4m - 3m", 3), ("12m / 2 / 3", 2), ("2 ^ 3 ^ 1 * 1m", 8)],
)  # fmt: skip
def test_values_are_computed(sample: Sample, value: str, meters: float) -> None:
    """As constants, and from a drawn number that is 1."""
    found = scene(sample, f"param a = {value}\n" + STRAIGHT)
    assert found.values["a"] == pytest.approx(meters)
    drawn = f"param one = integer(1, 1)\nparam a = ({value}) * one\n" + STRAIGHT
    assert scene(sample, drawn).values["a"] == pytest.approx(meters)


@pytest.mark.parametrize(
    ("value", "low", "high"),
    [("-(1m..2m)", -2, -1), ("abs(-2m..-1m)", 1, 2), ("3m - (1m..2m)", 1, 2),
     ("min(1m..2m, 1.5m)", 1, 1.5), ("max(1m..2m, 1.5m)", 1.5, 2), ("2m / (1..2)", 1, 2)],
)  # fmt: skip
def test_drawn_values_are_computed(sample: Sample, value: str, low: float, high: float) -> None:
    text = f"param a = {value}\n" + STRAIGHT
    drawn = [scene.values["a"] for scene in sample(text, 40).scenes]
    assert low <= min(drawn) < low + 0.2 * (high - low)
    assert high - 0.2 * (high - low) < max(drawn) <= high


SQUARE = "draw with waypoints { points: [(0m, 0m), (40m, 0m), (40m, 40m), (0m, 40m)] }"


def test_a_road_may_be_closed_by_an_option(sample: Sample) -> None:
    """From its last point a closed road goes on to its first one: about 40 m."""
    (open_road,) = scene(sample, f"road main {{ {SQUARE} }}").roads
    (ring,) = scene(sample, f"road main {{ {SQUARE}, closed: true }}").roads
    assert (open_road.closed, ring.closed) == (False, True)
    assert 30 < ring.length - open_road.length < 60


def test_the_number_of_lanes_may_be_drawn(sample: Sample) -> None:
    text = f"road main {{ lanes: integer(1, 3), width: 6m, {SQUARE} }}"
    roads = [found.roads[0] for found in sample(text, 20).scenes]
    assert {road.lanes for road in roads} == {1, 2, 3}
    for road in roads:
        assert len(road.lane_list) == road.lanes
        assert sum(lane.width[0] for lane in road.lane_list) == pytest.approx(6.0)


LEGEND = '''
image plan from """
....T....
#########
""" { scale: 10m/px, legend: { "#": road, "T": tree } }
network town from plan
'''


def test_things_that_are_drawn_keep_clear_of_those_of_a_legend(sample: Sample) -> None:
    """The tree is 10 m wide about x = 45 m; a box of 1 m keeps half a meter from it: 51 m."""
    text = LEGEND + "object post is box at (44m..60m, 15m)"
    found = [
        next(o for o in scene.objects if o.name == "post") for scene in sample(text, 60).scenes
    ]
    assert 51.0 <= min(post.x for post in found) < 52.0
    assert max(post.x for post in found) > 59.0


def test_who_has_no_room_is_told_whom_it_meets(sample: Sample) -> None:
    text = STRAIGHT + "object first is box on main at 20m\nobject second is box on main at 20.2m\n"
    with pytest.raises(DiagnosticError) as error:
        sample(text)
    message = error.value.diagnostics[0].message
    assert "`second`" in message
    assert "`first`" in message


def test_what_follows_a_group_without_copies_is_rejected_or_has_none(sample: Sample) -> None:
    text = STRAIGHT + "object posts is box on main at 5m { count: 0, spacing: 3m }\n"
    assert scene(sample, text).objects == ()


def test_copies_in_a_row_are_a_spacing_apart(sample: Sample) -> None:
    text = STRAIGHT + "object posts is box on main at 5m { count: 3, spacing: 4m }\n"
    assert [post.start for post in scene(sample, text).objects] == [5, 9, 13]


def test_each_copy_draws_its_own_kind_and_options(sample: Sample) -> None:
    text = STRAIGHT + (
        "object things is choice(tree(length: 2m..3m), cone) on main at 0%..100% { count: 12 }\n"
    )
    things = scene(sample, text).objects
    kinds = {thing.kind for thing in things}
    assert kinds == {"tree", "cone"}
    trees = [thing.length for thing in things if thing.kind == "tree"]
    assert len(set(trees)) == len(trees)
    assert all(2 <= length <= 3 for length in trees)
    assert {thing.length for thing in things if thing.kind == "cone"} == {0.35}


def test_a_road_of_a_displaced_network_ends_where_its_streets_do(sample: Sample) -> None:
    """One street of 90 m whose second half lies 2 m further left: so does the end of the road."""
    text = '''
image plan from """
##########
""" { scale: 10m/px, legend: { "#": road } }
network town from plan
network moved from town { perturb with shift { at: 20m, offset: 2m, length: 20m } }
road main from moved
'''
    roads = {road.name: road for road in scene(sample, text).roads}
    main, street = roads["main"], roads["moved/1"]
    assert (main.x[0], main.y[0], main.x[-1], main.y[-1]) == pytest.approx((5, 5, 95, 7))
    assert main.y == pytest.approx(street.y)
    assert main.y[19] == pytest.approx(5, abs=0.05)
    assert main.y[30] == pytest.approx(6, abs=0.05)
    assert main.y[41] == pytest.approx(7, abs=0.05)
