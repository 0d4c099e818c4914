"""`check` finds lanes that an agent cannot change to."""

from __future__ import annotations

import pytest

import roadlang
from roadlang import testing
from tests.frontdoor.test_fixed_faults import faults

LISTED = (
    "road main { draw with segments { pieces: [straight(300m)] }\n"
    "  right: [drive(3.5m), drive(3.5m), shoulder(2m)]\n"
)
MERGE, CHANGE = "drive with merge { to: left }", "drive with change_lane { to: right }"


@pytest.mark.parametrize(
    ("lanes", "agent", "is_fault"),
    [
        ("}", f"lane: -1, drive with traffic, {MERGE}", True),
        ("}", "lane: -1, drive with traffic, drive with merge", True),
        ("}", f"lane: -2, drive with traffic, {MERGE}", False),
        ("}", f"lane: -2, drive with traffic, {CHANGE}", False),
        ("}", f"lane: -3, drive with traffic, {CHANGE}", True),
        ("}", f"lane: choice(-1, -2), drive with traffic, {MERGE}", False),
        ("}", f"lane: -1, drive with traffic, {CHANGE}, {MERGE}", False),
        ("}", "lane: -1, drive with traffic, drive with merge { when: ego.lane == -2 }", False),
        ("}", f"lane: -1, facing: back, drive with traffic, {MERGE}", False),
        ("left: [drive(3.5m)] }", f"lane: -1, drive with traffic, {MERGE}", True),
        ("left: [drive(3.5m)] }", f"drive with traffic, {MERGE}", True),
        ("left: [drive(3.5m)] }", f"side: right, drive with traffic, {MERGE}", False),
        ("left: [drive(3.5m)] }", "lane: -1, drive with change_lane { to: left }", True),
        (
            "left: [drive(3.5m)] }",
            "lane: -1, drive with change_lane { to: left, force: true }",
            False,
        ),
        (
            "left: [drive(3.5m)] }",
            "lane: -1, drive with change_lane { to: left, duration: 2s..4s }",
            False,
        ),
        ("left: [drive(3.5m)] }", "lane: -1, drive with merge { to: 1 }", False),
        ("left: [parking(2.3m)] }", "lane: -1, drive with change_lane { to: left }", False),
        ("left: [parking(2.3m)] }", f"lane: -1, drive with traffic, {MERGE}", True),
        ("}", "lane: -2, drive with traffic, drive with merge { to: right }", True),
        ("left: [drive(3.5m)] }", f"lane: 1, drive with traffic, {MERGE}", False),
        ("}\nworld { traffic: left }", f"lane: -1, drive with traffic, {MERGE}", False),
    ],
)
def test_a_lane_beside_the_own_one_has_to_be_there(lanes: str, agent: str, is_fault: bool) -> None:
    text = f"{LISTED}{lanes}\nagent ego is car on main at 50m {{ {agent} }}\n"
    assert [code for code, _ in faults(text)] == ["RL613"] * is_fault


def test_the_side_on_which_no_lane_is_and_the_lanes_are_named() -> None:
    text = (
        f"{LISTED}}}\nagent ego is car on main at 9m {{ lane: -1, drive with car_follow, {MERGE} }}"
    )
    (found,) = [d for d in roadlang.loads(text).check() if d.is_error]
    assert found.message == "`main` has no lane to the left of -1"
    assert found.help == ("its lanes from left to right are -1, -2, -3",)


def test_lanes_that_no_controller_of_this_kind_takes_are_shown_with_what_they_are() -> None:
    text = (
        "road main { draw with segments { pieces: [straight(300m)] }, sidewalks: 2m }\n"
        f"agent ego is car on main at 9m {{ drive with car_follow, {MERGE} }}"
    )
    (found,) = [d for d in roadlang.loads(text).check() if d.is_error]
    assert found.message == "`main` has no lane to the left of -1 for `merge`"
    lanes = "2 (`sidewalk`), 1 (`drive`, oncoming), -1 (`drive`), -2 (`sidewalk`)"
    assert found.help == (f"its lanes from left to right are {lanes}",)


@pytest.mark.parametrize("maneuver", ["merge", "change_lane", "change_lane { force: true"])
@pytest.mark.parametrize("kind", ["drive", "bus", "shoulder", "bike"])
@pytest.mark.parametrize(
    ("side", "lanes"),
    [
        ("left", "left: [{}(2.5m)], right: [drive(3.5m)]"),
        ("right", "left: [drive(3.5m)], right: [drive(3.5m), {}(2.5m)]"),
    ],
)
def test_check_and_drive_agree_on_which_lanes_can_be_changed_to(
    maneuver: str, kind: str, side: str, lanes: str
) -> None:
    start = f"{maneuver}," if "{" in maneuver else f"{maneuver} {{"
    change = f"{start} to: {side}, duration: 2s"
    text = (
        f"road main {{ draw with segments {{ pieces: [straight(90m)] }}, {lanes.format(kind)} }}\n"
        "agent ego is car on main at 9m { lane: -1, drive with lane_follow { speed: 10m/s }\n"
        f"drive with {change} }} }}"
    )
    # Where the change has a condition, `check` does not judge it.
    driven = text.replace("duration: 2s", "duration: 2s, when: ego.station > 10m")
    (drive,) = testing.sample(driven, 1).run("builtin")
    assert (set(drive.trace.agents["ego"].lane.tolist()) == {-1}) == bool(faults(text))
