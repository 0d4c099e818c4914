"""Positions by another agent or object, rows, anywhere on a road, speeds at the start."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import pytest

from roadlang import DiagnosticError, loads, testing
from roadlang.ir.scene import SceneActor
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
ROAD = (
    "road main { draw with segments { pieces: [straight(300m)] }, width: 14m, lanes: 4 }\n"
    "agent ego is car on main at 100m { lane: -1, drive with lane_follow { speed: 20m/s } }\n"
)


def placed(sample: Sample, text: str, **more: Any) -> dict[str, SceneActor]:
    (scene,) = sample(ROAD + text, **more).scenes
    return {thing.name: thing for thing in (*scene.agents, *scene.objects)}


@pytest.mark.parametrize(
    ("position", "start", "lane", "facing"),
    [
        ("ahead_of(ego, 20m)", 100 + 20 + 4.5, -1, "forward"),
        ("behind(ego, 15m)", 100 - 15 - 4.5, -1, "forward"),
        ("beside(ego, left)", 100, 1, "back"),
        ("beside(ego, right)", 100, -2, "forward"),
        ("ahead_of(oncoming, 20m)", 200 - 20 - 4.5, 2, "back"),
        ("behind(oncoming, 20m)", 200 + 20 + 4.5, 2, "back"),
        ("beside(oncoming, left)", 200, 1, "back"),
        ("ahead_of(truck, 1m)", 250 + 1 + 4.5 + 2.25, -2, "forward"),
    ],
)
def test_a_car_is_placed_by_another(
    sample: Sample, position: str, start: float, lane: int, facing: str
) -> None:
    text = (
        "agent oncoming is car on main at 200m { lane: 2 }\n"
        "agent truck is truck on main at 250m { lane: -2 }\n"
        f"agent other is car at {position}\n"
    )
    other = placed(sample, text)["other"]
    assert (other.road, other.lane, other.facing) == ("main", lane, facing)
    assert other.start == pytest.approx(start)


def test_positions_follow_one_another(sample: Sample) -> None:
    text = "agent a is car at ahead_of(ego, 5m)\nagent b is car at ahead_of(a, 5m)\n"
    things = placed(sample, text + "agent c is car at beside(b, right)\n")
    assert things["b"].start == pytest.approx(100 + 2 * 9.5)
    assert things["c"].start == things["b"].start
    assert things["c"].lane == -2


def test_beside_what_stands_next_to_the_road_is_next_to_it(sample: Sample) -> None:
    text = (
        "object van is parked_van on main at 50m { side: right, offset: 1m }\n"
        "object bin is bin at beside(van, right)\n"
    )
    things = placed(sample, text)
    assert things["van"].offset == pytest.approx(-7 - 1 - 1)
    assert things["bin"].offset == pytest.approx(-9 - 1 - 1 - 0.25)


def test_each_copy_is_placed_by_that_of_its_number(sample: Sample) -> None:
    text = (
        "agent cars is car on main at 150m { count: 3, spacing: 20m, lane: -2 }\n"
        "agent followers is car at behind(cars, 2m) { count: 3 }\n"
    )
    things = placed(sample, text)
    for number in range(3):
        ahead, behind = things[f"cars[{number}]"], things[f"followers[{number}]"]
        assert ahead.start == pytest.approx(150 + 20 * number)
        assert behind.start == pytest.approx(150 + 20 * number - 2 - 4.5)


def test_a_row_is_placed_as_a_whole(sample: Sample) -> None:
    text = "agent row is car on main at random { count: 5, spacing: 6m..9m, lane: -1 }\n"
    for seed in range(20):
        things = placed(sample, text, seed=seed)
        starts = [things[f"row[{number}]"].start for number in range(5)]
        gaps = [b - a for a, b in pairwise(starts)]  # type: ignore[operator]
        assert all(6 <= gap <= 9 for gap in gaps)
        assert len(set(gaps)) == 4
        assert all(abs(start - 100) > 4.99 for start in starts)  # type: ignore[operator]


@pytest.mark.parametrize(
    ("lane", "expected"),
    [
        ("ego.start_lane", -1),
        ("ego.start_lane + 1", 1),
        ("ego.start_lane + 2", 2),
        ("ego.start_lane - 1", -2),
        ("oncoming.start_lane - 2", -1),
        ("oncoming.start_lane - 1", 1),
    ],
)
def test_lanes_are_counted_from_that_of_another(sample: Sample, lane: str, expected: int) -> None:
    text = (
        "agent oncoming is car on main at 200m { lane: 2 }\n"
        f"agent other is car on main at 20m {{ lane: {lane} }}\n"
    )
    assert placed(sample, text)["other"].lane == expected


def test_anywhere_is_all_of_the_road(sample: Sample) -> None:
    text = "object trees is tree on main at random { count: 40, side: left, offset: 2m..20m }\n"
    starts = [tree.start for tree in placed(sample, text).values() if tree.kind == "tree"]
    assert min(starts) < 30  # type: ignore[type-var, operator]
    assert max(starts) > 270  # type: ignore[type-var, operator]


@pytest.mark.parametrize(
    ("options", "speed"),
    [
        ("drive with lane_follow { speed: 9m/s }", 9),
        ("start_speed: 36km/h, drive with lane_follow { speed: 9m/s }", 10),
        ("start_speed: 0m/s, drive with lane_follow { speed: 9m/s }", 0),
        ("drive with lane_follow { speed: 9m/s, when: ego.speed > 2m/s }", 0),
        ("side: right, offset: 1m, drive with lane_follow { speed: 9m/s }", 0),
        ("", 0),
    ],
)
def test_agents_begin_at_speed(sample: Sample, options: str, speed: float) -> None:
    text = f"agent other is car on main at 20m {{ {options} }}\n"
    assert placed(sample, text)["other"].start_speed == pytest.approx(speed)


def test_a_drive_begins_at_speed() -> None:
    (drive,) = loads(ROAD + "simulate with builtin { duration: 1s }\n").sample(1).run()
    assert drive.trace.agents["ego"].speed[0] == pytest.approx(20)


@pytest.mark.parametrize(
    ("text", "code", "help"),
    [
        ("agent a is car at ahed_of(ego, 5m)", "RL", "ahead_of"),
        ("agent a is car at ahead_of(ego)", "RL", "distance"),
        ("agent a is car at ahead_of(kiosk, 5m)", "RL240", ""),
        ("agent a is car on side at ahead_of(ego, 5m)", "RL248", "main"),
        ("agent a is car on main at 5m { spacing: 9m }", "RL249", ""),
        ("agent a is car at random", "RL", ""),
        ("object a is tree on main at 5m { start_speed: 9m/s }", "RL220", ""),
    ],
)
def test_what_cannot_be_is_refused(text: str, code: str, help: str) -> None:
    more = (
        "road side { draw with segments { pieces: [straight(90m)] } }\n"
        "object kiosk is building at (0m, 90m)\n"
    )
    (found,) = loads(ROAD + more + text + "\n").check()
    assert found.code.startswith(code)
    assert help in " ".join(found.help)


BENDING = (
    "road bend { draw with segments { start: (0m, 200m),"
    " pieces: [straight(40m), arc(20m, 90deg), straight(100m)] }, lanes: 2 }\n"
)


@pytest.mark.parametrize(
    ("place", "facing", "speed"),
    [
        ("60m", "forward", math.sqrt(4.5 * 20.0)),
        ("20m", "forward", math.sqrt(4.5 * 20.0 + 2 * 4.0 * 20.0)),
        ("20m", "back", 30.0),
        ("100m", "forward", 30.0),
        ("91.4m", "back", math.sqrt(4.5 * 20.0 + 2 * 4.0 * 20.0)),
    ],
)
def test_nobody_begins_too_fast_for_the_bend_ahead(
    sample: Sample, place: str, facing: str, speed: float
) -> None:
    """Lateral acceleration 4.5 m/s^2 in the bend, and braking by 4 m/s^2 before it."""
    drive = "drive with lane_follow { speed: 30m/s, deceleration: 4m/s^2 }"
    text = f"agent other is car on bend at {place} {{ facing: {facing}, {drive} }}\n"
    assert placed(sample, BENDING + text)["other"].start_speed == pytest.approx(speed, rel=0.05)


@pytest.mark.parametrize(
    ("text", "stations"),
    [
        ("a is car on main at 60m { count: 3, spacing: 10m }", [60, 70, 80]),
        ("a is car on main at 60m { count: 3, spacing: -10m }", [60, 50, 40]),
        ("a is car at behind(lead, 15.5m) { count: 3, spacing: 10m }", [70, 60, 50]),
        ("a is car at ahead_of(lead, 15.5m) { count: 3, spacing: 10m }", [110, 120, 130]),
        ("a is car at ahead_of(back, 15.5m) { count: 3, spacing: 10m }", [130, 120, 110]),
        ("a is car at behind(back, 15.5m) { count: 3, spacing: 10m }", [170, 180, 190]),
    ],
)
def test_a_row_goes_on_away_from_what_it_is_placed_by(
    sample: Sample, text: str, stations: list[float]
) -> None:
    road = "road main { draw with waypoints { points: [(0m, 0m), (300m, 0m)] } }\n"
    lead = "agent lead is car on main at 90m\nagent back is car on main at 150m { facing: back }\n"
    (scene,) = sample(road + lead + f"agent {text}").scenes
    row = [agent.start for agent in scene.agents if agent.name.startswith("a[")]
    assert row == pytest.approx(stations)


def test_a_row_behind_another_follows_the_lanes_of_a_network_back(sample: Sample) -> None:
    text = (
        'image plan from """\n#########\n""" { scale: 20m/px, legend: { "#": road } }\n'
        "network town from plan\n"
        "agent lead is car on town { route: [(120m, 10m), (170m, 10m)] }\n"
        "agent a is car at behind(lead, 5.5m) { count: 3, spacing: 10m }\n"
        "agent b is car on town at (70m, 10m) { count: 3, spacing: -10m }\n"
    )
    (scene,) = sample(text).scenes
    lead, *others = [agent.x for agent in scene.agents]
    assert [lead - x for x in others[:3]] == pytest.approx([10.0, 20.0, 30.0], abs=0.1)
    assert [b - a for a, b in pairwise(others[3:])] == pytest.approx([-10.0, -10.0], abs=0.1)


def test_one_copy_of_a_group_stands_for_itself(sample: Sample) -> None:
    found = placed(
        sample,
        "agent cars is car on main at 120m { lane: 1, facing: forward, count: 3, spacing: 20m }\n"
        "agent after is car on main at ahead_of(cars[1], 50m)\n"
        "object box is rock on main at cars[2].start + 40m { side: left, offset: 1m }\n"
        "agent row is car on main at behind(cars[0], 10m) { count: 2, spacing: 8m }\n",
    )
    assert found["after"].start == 140 + 50 + 4.5
    assert found["box"].start == 160 + 40
    assert [found[f"row[{k}]"].start for k in (0, 1)] == pytest.approx([105.5, 97.5])


def test_a_copy_that_a_scene_lacks_is_nothing_to_be_placed_by(sample: Sample) -> None:
    text = (
        "agent cars is car on main at 120m { count: integer(0, 2), spacing: 20m }\n"
        "agent after is car on main at ahead_of(cars[1], 20m)\n"
    )
    scenes = sample(ROAD + text, 6).scenes
    assert len(scenes) == 6
    assert {sum(a.group == "cars" for a in scene.agents) for scene in scenes} == {2}


def test_numbers_of_placement_are_of_one_copy(sample: Sample) -> None:
    text = (
        "agent cars is car on main at 110m..290m { lane: 2, count: 3, apart: 5m }\n"
        "require order: cars[0].start < cars[1].start and cars[1].start < cars[2].start\n"
        "require far: distance(cars[0], cars[2]) > 60m\n"
    )
    for scene in sample(ROAD + text, 5).scenes:
        starts = [float(a.start or 0.0) for a in scene.agents if a.group == "cars"]
        assert starts == sorted(starts)
        assert starts[2] - starts[0] > 60


def test_signals_of_a_drive_are_of_one_copy() -> None:
    text = (
        "agent cars is car on main at 20m { lane: 2, facing: forward, count: 2, spacing: 15m,"
        " drive with lane_follow { speed: 5m/s }, drive with brake { when: "
        "distance(cars[1], ego) < 55m } }\n"
        "expect first: always (distance(cars[0], ego) > 1m)\n"
    )
    scene = loads(ROAD + text).sample()[0]
    drive = scene.run("builtin", duration=8.0)
    agents = drive.trace.agents
    apart = [
        ((agents[name].x - agents["ego"].x) ** 2 + (agents[name].y - agents["ego"].y) ** 2) ** 0.5
        for name in ("cars[0]", "cars[1]")
    ]
    assert drive.verdicts["first"].robustness == pytest.approx(apart[0].min() - 1)
    assert agents["cars[0]"].speed[-1] == pytest.approx(agents["cars[1]"].speed[-1])


@pytest.mark.parametrize(
    ("things", "says"),
    [
        ("object wall is box on main at 20m\nagent ego is car on main at 19m..21m",
         "`wall` is in the way of `ego`"),
        ("object wall is box at (0m..0.1m, 0m) { count: 2 }",
         "copies of `wall` are in the way of each other"),
        ("agent cars is car on main at 20m { count: 2, length: 4.2m..4.4m }",
         "put its copies in a row with `spacing: 5m` or more, or anywhere with `at random`"),
        ("object wall is box at (2m, 0m) { count: 2, length: 1m..2m }",
         "give each copy a place of its own: `at (10m..40m, 20m)` draws one for each"),
        ("agent ego is car on main at 20m..30m { lane: choice(-1, 1) }\n"
         "agent b is car on main at 50m { lane: ego.start_lane + choice(5, 6) }",
         "has no lane"),
        ("agent ego is car on main at 20m..30m\nrequire far: ego.start > 29m\n"
         "agent b is car on main at behind(ego, 50m..60m)",
         "beyond the end of `main`"),
    ],
)  # fmt: skip
def test_what_is_in_the_way_of_what_is_said_where_there_is_no_scene(things: str, says: str) -> None:
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(f"{STRAIGHT.replace(', width: 8m', '')}\n{things}\n")
    assert says in str(caught.value)


@pytest.mark.parametrize(
    "beside",
    ["at beside(ego, right)", "at 80m { lane: ego.start_lane - 1 }", "at 80m { lane: next_one }"],
)
def test_a_lane_next_to_a_random_one_is_drawn_again_where_the_road_ends(beside: str) -> None:
    text = f"""
road main {{ draw with segments {{ pieces: [straight(200m)] }}, lanes: 4 }}
agent ego is car on main at 50m {{ lane: choice(-1, -2) }}
let next_one = ego.start_lane - 1
agent b is car on main {beside}
"""
    scenes = testing.sample(text, n=5)
    lanes = {tuple(agent.lane for agent in scene.agents.values()) for scene in scenes}
    assert lanes == {(-1, -2)}
    with pytest.raises(DiagnosticError, match=r"RL613.*`main` has no lane -3"):
        testing.sample(text.replace("choice(-1, -2)", "-2"))


def test_turns_that_can_be_made_from_nowhere_are_named() -> None:
    text = '''
image plan from """
....#....
....#....
#########
""" { scale: 12m/px, legend: { "#": road } }
network town from plan
agent ego is car on town { route: [choice(left, right), left, left], drive with traffic }
'''
    with pytest.raises(DiagnosticError, match="no lane of `town` lets `ego` go"):
        testing.sample(text)


def test_an_agent_starts_where_it_can_make_its_turns_however_rare_that_is(sample: Sample) -> None:
    text = '''
image plan from """
#####################################
.........................#...........
.........................#...........
#####################################
.........................#...........
""" { scale: 12m/px, legend: { "#": road } }
network town from plan { lanes: 4 }
agent ego is motorcycle on town { route: [straight, left], drive with traffic }
'''
    found = sample(text, n=4)
    assert found.candidates == 4  # the stub in the south is a hundredth of the network
    assert all(scene.agents[0].y < 12 for scene in found.scenes)
