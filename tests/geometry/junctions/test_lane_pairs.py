"""Which lanes lead where: right turns from the curb, left turns from the middle, none crossing."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry.junctions.arms import ArmLane
from roadlang.geometry.junctions.lane_pairs import ArmLanes, lane_pairs


def arm(degrees: float, inbound: int, outbound: int) -> ArmLanes:
    into = tuple(ArmLane(i + 1, 10.0 - i, 3.5, True, False) for i in range(inbound))
    out = tuple(ArmLane(-i - 1, i - 10.0, 3.5, False, True) for i in range(outbound))
    return ArmLanes(into, out, math.radians(degrees))


def from_south(*others: ArmLanes, lanes: int) -> list[tuple[int, int, str]]:
    """(lane from the curb, target arm, turn) of the lanes that come from the south."""
    arms = [arm(270, lanes, 1), *others]
    return [(p.source_lane, p.target, p.turn) for p in lane_pairs(arms) if p.source == 0]


EAST, NORTH, WEST = arm(0, 1, 1), arm(90, 1, 1), arm(180, 1, 1)


def test_a_single_lane_leads_everywhere() -> None:
    pairs = from_south(EAST, NORTH, WEST, lanes=1)
    assert pairs == [(0, 1, "right"), (0, 2, "straight"), (0, 3, "left")]


def test_with_two_lanes_for_three_turns_both_go_straight_on() -> None:
    pairs = from_south(EAST, NORTH, WEST, lanes=2)
    assert pairs == [(0, 1, "right"), (0, 2, "straight"), (1, 2, "straight"), (1, 3, "left")]


def test_with_lanes_enough_each_turn_has_its_own() -> None:
    pairs = from_south(EAST, NORTH, WEST, lanes=4)
    assert pairs == [(0, 1, "right"), (1, 2, "straight"), (2, 2, "straight"), (3, 3, "left")]


def test_all_lanes_of_a_roundabout_lead_on_round_it() -> None:
    ring, exit_road = arm(270, 2, 0), arm(0, 0, 1)
    circling = ArmLanes(ring.inbound, ring.outbound, ring.heading, circles=True)
    pairs = lane_pairs([circling, exit_road, arm(100, 0, 2)])
    assert [(p.source_lane, p.target) for p in pairs] == [(0, 1), (0, 2), (1, 2)]


def test_a_lane_more_ahead_is_fed_by_the_last_lane() -> None:
    arms = [arm(270, 2, 0), arm(90, 0, 3)]
    assert [(p.source_lane, p.target_lane) for p in lane_pairs(arms)] == [(0, 0), (1, 1), (1, 2)]


def test_a_lane_less_ahead_is_merged_into_the_last() -> None:
    arms = [arm(270, 3, 0), arm(90, 0, 2)]
    assert [(p.source_lane, p.target_lane) for p in lane_pairs(arms)] == [(0, 0), (1, 1), (2, 1)]


def test_left_turns_enter_the_lane_in_the_middle() -> None:
    arms = [arm(270, 1, 0), arm(180, 0, 3)]
    assert [p.target_lane for p in lane_pairs(arms)] == [2]


@given(
    st.lists(st.tuples(st.integers(0, 359), st.integers(0, 4), st.integers(0, 4)),
             min_size=2, max_size=6, unique_by=lambda item: item[0])
)  # fmt: skip
def test_turns_of_one_arm_do_not_cross(shapes: list[tuple[int, int, int]]) -> None:
    """A lane further left never turns further right, and every way out is used."""
    arms = [arm(*shape) for shape in shapes]
    pairs = lane_pairs(arms)
    for source, lanes in enumerate(arms):
        mine = [p for p in pairs if p.source == source]
        for a in mine:
            assert all(
                b.source_lane >= a.source_lane or b.angle <= a.angle
                for b in mine
                if b.target != a.target
            )
        wanted = {i for i, other in enumerate(arms) if i != source and other.outbound}
        assert {p.target for p in mine} == (wanted if lanes.inbound else set())
        assert {p.source_lane for p in mine} == (
            set(range(len(lanes.inbound))) if wanted else set()
        )
