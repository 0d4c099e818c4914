"""What controllers see of lanes, limits and neighbors, from both sides of the road."""

from __future__ import annotations

import math
import weakref

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.observation import ObservationBatch
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.observing.observing import View
from roadlang.simulation.observing.surroundings import Surroundings

STREET = """
road main {
  draw with segments { pieces: [PIECES] }
  speed_limit: 50km/h
  left:  [drive(3m), bike(1m)]
  right: [drive(3m), drive(4m, speed_limit: 30km/h), sidewalk(2m)]
}
"""
STRAIGHT = "straight(200m)"
CURVED = "straight(60m), arc(40m, 90deg), straight(60m)"


def observed(text: str) -> tuple[ObservationBatch, View]:
    """What all agents of a scene see at the start."""
    scene = testing.sample(text)[0].record
    world = world_of([scene], {}, 0.02, 0.1)
    view = View(world, world.poses, 0.1, Surroundings(world))
    return view.of(np.arange(len(scene.agents))), view


def seen(more: str, pieces: str = STRAIGHT) -> tuple[ObservationBatch, View]:
    """The same, on the street."""
    return observed(STREET.replace("PIECES", pieces) + more)


# The drivable lanes lie in the middle: lane 1 is 3 m left, -1 is 3 m, -2 is 4 m wide.
FORTH = "agent a is car on main at 40m { lane: -1, drive with brake }\n"
BACK = "agent b is car on main at 80m { lane: 1, facing: back, drive with brake }\n"


def test_what_is_seen_is_freed_with_its_last_use() -> None:
    both, view = seen(FORTH + BACK)
    zero = np.zeros(2)
    both.line_ahead(1.0), both.path_ahead(zero), both.speed_for_bends(3.0, 3.0, 0.0)
    both.vehicle_ahead(), both.obstacle_ahead(), both.lane_end(), both.lane_place()
    both.offset_of_lane("left"), both.direction_of_lane("left"), both.speed_limit_ahead(3.0, 0.0)
    both.stop_ahead(), both.right_of_way(zero, zero), both.junction_ahead()
    both.nearby(9.0), both.nearest(1)
    left = weakref.ref(view)
    del both, view
    assert left() is None  # at once, not when the garbage collector comes


def test_lanes_are_seen_from_the_direction_of_travel() -> None:
    both, _ = seen(FORTH + BACK)
    assert both.lane.tolist() == [-1, 1]
    assert both.lane_width == pytest.approx([3.0, 3.0])
    assert both.lane_offset == pytest.approx(both.road_offset)
    # forth: lanes 1, -1, -2 lie at +3.5, +0.5, -3; who comes back sees them at -3.5, -0.5, +3
    assert both.offset_of_lane("left") == pytest.approx([3.5, -0.5])
    assert both.offset_of_lane("right") == pytest.approx([-3.0, math.nan], nan_ok=True)
    assert both.offset_of_lane(-2) == pytest.approx([-3.0, 3.0])
    assert both.offset_of_lane(np.array([1, -1])) == pytest.approx([3.5, -0.5])
    assert both.direction_of_lane("left").tolist() == [-1.0, -1.0]
    assert both.offset_of_lane("inner") == pytest.approx([3.5, -0.5])
    assert both.offset_of_lane("outer") == pytest.approx([-3.0, math.nan], nan_ok=True)
    assert both.offset_of_lane("sidewalk") == pytest.approx([-6.0, 6.0])
    assert both.offset_of_lane("tram").tolist() == pytest.approx([math.nan] * 2, nan_ok=True)


def test_the_speed_limit_is_that_of_the_lane_or_of_the_road() -> None:
    outer = "agent c is car on main at 10m { lane: -2, drive with brake }\n"
    all_, _ = seen(FORTH + BACK + outer)
    assert all_.speed_limit == pytest.approx([50 / 3.6, 50 / 3.6, 30 / 3.6])


def test_left_hand_traffic_sees_the_mirror_image() -> None:
    text = """
    road main { draw with segments { pieces: [straight(200m)] }, lanes: 4, width: 14m }
    agent a is car on main at 40m { drive with brake }
    world { traffic: SIDE }
    """
    here, there = (observed(text.replace("SIDE", side))[0] for side in ("right", "left"))
    assert here.lane[0] == -there.lane[0] == -1
    assert here.offset_of_lane("inner") == pytest.approx(1.75)
    for one, other in (("inner", "inner"), ("outer", "outer"), ("left", "right")):
        assert here.offset_of_lane(one) == pytest.approx(-there.offset_of_lane(other))


@pytest.mark.parametrize("pieces", [STRAIGHT, CURVED])
def test_neighbors_are_ahead_and_to_the_left_round_bends_too(pieces: str) -> None:
    tree = "object tree is tree on main at 100m { side: left, offset: 1m }\n"
    both, _ = seen(FORTH + BACK + tree, pieces)
    near = both.nearby(500.0)
    a, b = near.single(0), near.single(1)
    assert [one.name for one in a] == ["b", "tree"]
    assert [one.kind for one in b] == ["car", "tree"]
    assert (a[0].ahead, a[0].left) == pytest.approx((40.0, 3.0), abs=0.1)
    assert (b[0].ahead, b[0].left) == pytest.approx((40.0, 3.0), abs=0.1)
    assert a[1].ahead == pytest.approx(60.0, abs=0.3)
    assert b[1].ahead == pytest.approx(-20.0, abs=0.3)
    assert a[1].left == pytest.approx(b[1].left * -1 + 3.0, abs=0.1)
    assert both.nearby(30.0).there.sum() == both.nearby(30.0).there[1].sum()


def test_who_comes_toward_an_agent_has_a_negative_pace() -> None:
    _, view = seen(FORTH + BACK, CURVED)
    view.world.motion.speed[:] = [8.0, 5.0]
    near = view.of(np.arange(2)).nearby(500.0)
    assert near.single(0)[0].speed == 5.0
    assert near.single(0)[0].pace < -2.0
    assert near.single(1)[0].pace < -4.0


def test_points_of_the_path_lie_on_the_line_ahead() -> None:
    _, view = seen("agent a is car on main at 58.3m { lane: -1, drive with brake }\n", CURVED)
    rows, distances = np.arange(1), np.array([0.4, 7.7, 20.1])
    found = np.hstack([np.vstack(view.line_ahead(rows, distance)[:2]) for distance in distances])
    curve = np.stack(view.path_ahead(rows, distances))[:, :, 0]
    assert curve == pytest.approx(found, abs=1e-4)


@pytest.mark.parametrize("pieces", [STRAIGHT, CURVED])
def test_curvatures_ahead_are_those_of_the_line_ahead_to_the_last_bit(pieces: str) -> None:
    _, view = seen(FORTH + BACK, pieces)
    rows = np.array([1, 0])
    distances = np.array([[0.0, -1.3], [7.7, 20.1], [35.0, 500.0]])
    one_by_one = [view.line_ahead(rows, distance)[3] for distance in distances]
    assert view.curvatures_ahead(rows, distances).tolist() == np.array(one_by_one).tolist()


def test_agents_are_looked_up_by_the_array_that_names_them() -> None:
    """The same array gives the same track, another array of the same agents one that is equal."""
    _, view = seen(FORTH + BACK)
    track, rows = view.world.track, np.array([1])
    part = track.of_rows(rows)
    assert track.of_rows(rows) is part
    other = track.of_rows(np.array([0]))
    assert part.row.tolist() == track.row[[1]].tolist()
    assert other.row.tolist() == track.row[[0]].tolist()
    for number in range(200):
        assert track.of_rows(np.array([number % 2])).row.tolist() == [track.row[number % 2]]


ACROSS = '''
image plan from """
....#....
....#....
#########
....#....
....#....
""" {{ scale: 20m/px, legend: {{ "#": road }} }}
network town from plan {{ {lanes} }}
world {{ traffic: {side} }}
agent a is car on town {{ route: [(40m, 50m), (170m, 50m)], drive with brake }}
'''
TWO = "left: [drive(3m)], right: [drive(3m)]"


@pytest.mark.parametrize(
    ("lanes", "side", "left", "right"),
    [
        (TWO, "right", 3.0, math.nan),
        (TWO, "left", math.nan, -3.0),
        ("lanes: 1, oneway: true", "right", math.nan, math.nan),
    ],
)
def test_the_lanes_in_a_junction_are_those_of_its_roads(
    lanes: str, side: str, left: float, right: float
) -> None:
    one, _ = observed(ACROSS.format(lanes=lanes, side=side))
    middle = np.hypot(one.x - 90.0, one.y - 50.0)
    beside = one.lanes_beside(middle, np.zeros(1))
    assert beside.middle == pytest.approx(0.0, abs=0.01)
    assert beside.left == pytest.approx([left], abs=0.01, nan_ok=True)
    assert beside.right == pytest.approx([right], abs=0.01, nan_ok=True)
    oncoming = beside.left_direction if side == "right" else beside.right_direction
    assert oncoming == pytest.approx([-1.0 if lanes == TWO else math.nan], nan_ok=True)
