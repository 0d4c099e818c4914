"""Requirements on how far apart things are placed."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

import pytest

from roadlang import DiagnosticError, loads
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
TREES = "object trees is tree on main at random { count: 5, side: left, offset: 1m..9m }\n"


def test_members_of_a_group_are_compared_with_each_other(sample: Sample) -> None:
    text = STRAIGHT + TREES + "require apart: distance(trees, trees) > 20m\n"
    for scene in sample(text, 5).scenes:
        pairs = itertools.combinations(scene.objects, 2)
        least = min(math.hypot(a.x - b.x, a.y - b.y) for a, b in pairs)
        assert least > 20
        assert scene.requirements[0].robustness == pytest.approx(least - 20)


def test_survivors_of_another_requirement_keep_their_distances(sample: Sample) -> None:
    text = STRAIGHT + "param far = 0m..1m\n" + TREES
    text += "require first: far > 0.7m\nrequire apart: distance(trees, trees) > 20m\n"
    for scene in sample(text, 4).scenes:
        pairs = itertools.combinations(scene.objects, 2)
        assert min(math.hypot(a.x - b.x, a.y - b.y) for a, b in pairs) > 20


def test_gaps_are_between_outlines(sample: Sample) -> None:
    text = (
        STRAIGHT + "agent ego is car on main at 20m\nagent lead is truck on main at 30m..40m\n"
        "require near: gap(ego, lead) < 5m\n"
    )
    (scene,) = sample(text).scenes
    ego, lead = scene.agents
    gap = lead.x - ego.x - (4.5 + 9) / 2
    assert scene.requirements[0].robustness == pytest.approx(5 - gap)


def test_a_group_is_compared_with_another(sample: Sample) -> None:
    text = STRAIGHT + TREES + "object bins is bin on main at random { count: 3, side: right }\n"
    (scene,) = sample(text + "require near: distance(trees, bins) < 30m\n").scenes
    trees = [thing for thing in scene.objects if thing.kind == "tree"]
    bins = [thing for thing in scene.objects if thing.kind == "bin"]
    least = min(math.hypot(a.x - b.x, a.y - b.y) for a in trees for b in bins)
    assert scene.requirements[0].robustness == pytest.approx(30 - least)


@pytest.mark.parametrize("count", [0, 1])
def test_nothing_is_apart_from_itself(sample: Sample, count: int) -> None:
    text = STRAIGHT + TREES.replace("count: 5", f"count: {count}")
    assert len(sample(text + "require apart: distance(trees, trees) > 20m\n").scenes) == 1


def test_in_an_expectation_distances_are_those_of_the_drive(sample: Sample) -> None:
    text = (
        STRAIGHT + "agent ego is car on main at 20m\nagent lead is car on main at 40m\n"
        "expect apart: always (distance(ego, lead) > 5m)\n"
    )
    (scene,) = sample(text).scenes
    assert scene.expectations[0].domain == "drive"


def test_one_thing_is_not_compared_with_itself() -> None:
    text = STRAIGHT + "agent ego is car on main at 20m\nrequire r: distance(ego, ego) > 5m\n"
    (found,) = loads(text).check()
    assert "ego" in found.message


@pytest.mark.parametrize("pair", ["cars[0], cars", "cars, cars[0]", "cars[1], cars"])
@pytest.mark.parametrize(("number", "least"), [("distance", 15.0), ("gap", 10.5)])
def test_a_member_is_not_compared_with_itself_in_its_group(
    sample: Sample, pair: str, number: str, least: float
) -> None:
    row = STRAIGHT + "agent cars is car on main at 20m { count: 3, spacing: 15m }\n"
    condition = f"{number}({pair})"
    (scene,) = sample(row + f"require apart: {condition} > {least - 0.1}m\n").scenes
    assert scene.requirements[0].robustness == pytest.approx(0.1)
    with pytest.raises(DiagnosticError):
        loads(row + f"require apart: {condition} > {least + 0.1}m\n").sample(1)


def test_a_member_alone_in_its_group_is_far_from_all_others(sample: Sample) -> None:
    text = STRAIGHT + "agent cars is car on main at 20m { count: 1 }\n"
    assert len(sample(text + "require apart: distance(cars[0], cars) > 1km\n").scenes) == 1
