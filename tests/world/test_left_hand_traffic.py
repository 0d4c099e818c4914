"""Left-hand traffic: every scene is the mirror image of a scene with right-hand traffic."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from roadlang.ir.scene import Scene, SceneRoad
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]

RIGHT = "world { traffic: right }\n"
LEFT = "world { traffic: left }\n"


def road(options: str, y: str = "") -> str:
    points = f"[(0m, 0m), (60m, {y}12m), (120m, {y}5m)]"
    return f"road main {{ draw with waypoints {{ points: {points} }}\n{options} }}\n"


CASES = {
    "one": ("lanes: 1", "lanes: 1"),
    "two": ("lanes: 2", "lanes: 2"),
    "three": ("lanes: 3, width: 9m, sidewalks: 2m", "lanes: 3, width: 9m, sidewalks: 2m"),
    "four": ("lanes: 4, speed_limit: 30km/h", "lanes: 4, speed_limit: 30km/h"),
    "oneway": ("lanes: 2, oneway: true", "lanes: 2, oneway: true"),
    "lists": (
        "left: [drive(3m), bike], right: [drive(3.5m), bus, parking, sidewalk]",
        "right: [drive(3m), bike], left: [drive(3.5m), bus, parking, sidewalk]",
    ),
    "median": ("left: [median, drive], right: [drive]", "right: [median, drive], left: [drive]"),
}
ACTORS = (
    "agent ego is car on main at 20m\n"
    "agent other is car on main at 60m {{ lane: {lane} }}\n"
    "object tree is tree on main at 30m {{ side: {side}, offset: 1m }}\n"
)


def mirrored(road: SceneRoad) -> list[object]:
    return [
        (-lane.id, lane.kind, lane.direction, pytest.approx(lane.width), lane.marking)
        for lane in reversed(road.lane_list)
    ]


def plain(road: SceneRoad) -> list[object]:
    return [
        (lane.id, lane.kind, lane.direction, lane.width, lane.marking) for lane in road.lane_list
    ]


def only(sample: Sample, text: str) -> Scene:
    (scene,) = sample(text).scenes
    return scene


@pytest.mark.parametrize("case", CASES)
def test_lanes_and_places_are_mirrored(sample: Sample, case: str) -> None:
    right, left = CASES[case]
    image = only(sample, LEFT + road(left, "-") + ACTORS.format(lane=1, side="right"))
    scene = only(sample, RIGHT + road(right) + ACTORS.format(lane=-1, side="left"))
    assert plain(image.roads[0]) == mirrored(scene.roads[0])
    for one, other in zip(
        (*image.agents, *image.objects), (*scene.agents, *scene.objects), strict=True
    ):
        assert (one.x, one.y) == pytest.approx((other.x, -other.y))
        assert math.cos(one.heading + other.heading) == pytest.approx(1.0)
        assert one.facing == other.facing
        assert (one.lane or 0) == -(other.lane or 0)


@pytest.mark.parametrize("case", ["two", "four"])
def test_a_network_is_mirrored_with_its_junctions(sample: Sample, case: str) -> None:
    right, left = CASES[case]
    rows = ["#########", "....#....", "....#...."]

    def town(side: str, options: str, lines: list[str]) -> Scene:
        picture = "\n".join(lines)
        image = f'image plan from """\n{picture}\n""" {{ scale: 12m/px, legend: {{ "#": road }} }}'
        return only(sample, f"{side}{image}\nnetwork town from plan {{ {options} }}\n")

    scene, image = town(RIGHT, right, rows), town(LEFT, left, rows[::-1])
    turns = [
        sorted((one.turn, round(one.length, 3)) for one in network.junctions[0].connections)
        for network in (scene.networks[0], image.networks[0])
    ]
    swapped = {"left": "right", "right": "left"}
    assert sorted((swapped.get(turn, turn), length) for turn, length in turns[0]) == turns[1]
