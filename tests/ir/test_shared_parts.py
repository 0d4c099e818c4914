"""What several scenes have in common is written once, and reads as if it were written each time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, cast

import numpy as np
import pytest

from roadlang.ir import json_document
from roadlang.ir.encoding import to_json
from roadlang.ir.read_only import FrozenDict, FrozenList, is_unchangeable
from roadlang.ir.scene_actor import Call
from tests.backends.handmade_scenes import bend, town


def written_alone(value: object) -> str:
    """The text without anything known of other documents."""
    json_document._last[0] = {}
    return to_json(value)


def test_scenes_written_one_after_the_other_are_those_written_alone() -> None:
    scene = bend()
    road = scene.roads[0]
    moved = replace(road, x=tuple(x + 1.0 for x in road.x))
    scenes = [
        scene,
        replace(scene, index=1, roads=(moved, *scene.roads[1:])),
        replace(scene, index=2, agents=()),
        town(),
        scene,
    ]
    together = [to_json(each) for each in scenes]
    assert together == [written_alone(each) for each in scenes]


def test_a_part_at_another_depth_is_indented_as_it_stands_there() -> None:
    road = bend().roads[0]
    within = to_json({"first": road, "list": [road]})
    assert within == written_alone({"first": road, "list": [road]})
    assert '\n    "name": ' in within
    assert '\n      "name": ' in within


def test_only_the_last_document_is_remembered() -> None:
    to_json(bend())
    to_json({"a": 1})
    assert json_document._last[0] == {}


NUMBERS = [number + 0.5 for number in range(20)]


@dataclass(frozen=True)
class Holder:
    """A document of one part."""

    part: object


@pytest.mark.parametrize("within", ["list", "map", "call", "road", "list of lists"])
def test_what_changed_since_the_last_document_is_written_anew(within: str) -> None:
    numbers = list(NUMBERS)
    road = replace(bend().roads[0], x=cast(Any, numbers))
    part = {
        "list": numbers,
        "map": FrozenDict({"numbers": numbers}),
        "call": Call("ride", FrozenDict({"numbers": numbers})),
        "road": road,
        "list of lists": FrozenList([numbers]),
    }[within]
    before = to_json(Holder(part))
    numbers[0] = 99.25
    after = to_json(Holder(part))
    assert before != after
    assert after == written_alone(Holder(part))


@pytest.mark.parametrize("numbers", [tuple(NUMBERS), FrozenList(NUMBERS)], ids=["tuple", "list"])
def test_numbers_that_cannot_change_are_remembered(numbers: object) -> None:
    to_json(Holder(numbers))
    assert [part for part, _ in json_document._last[0].values()] == [numbers]


def test_the_roads_of_a_scene_are_remembered() -> None:
    scene = town()
    to_json(scene)
    remembered = {id(part) for part, _ in json_document._last[0].values()}
    assert {id(part) for part in (*scene.roads, *scene.networks)} <= remembered


@pytest.mark.parametrize(
    ("change", "kind"),
    [
        (lambda: FrozenDict(a=1).update(b=2), "map"),
        (lambda: FrozenDict(a=1).pop("a"), "map"),
        (lambda: FrozenList([1]).append(2), "list"),
        (lambda: FrozenList([2, 1]).sort(), "list"),
    ],
)
def test_what_cannot_be_changed_says_what_it_is(change: Any, kind: str) -> None:
    with pytest.raises(TypeError, match=f"this {kind} is read-only: change a copy of it"):
        change()


CHANGEABLE = [[1.5], {"a": 1}, np.zeros(2), object(), Holder([1]), Holder(np.zeros(2))]
UNCHANGEABLE = [1.5, "a", None, FrozenList([1, 2]), FrozenDict(a=1), Holder((1, "a")), bend()]


@pytest.mark.parametrize("put", [
    lambda part: part,
    lambda part: (part,),
    lambda part: (1.5, part, (part, "a")),
    lambda part: FrozenList([FrozenList([part])]),
    lambda part: FrozenDict(a=1.5, b=(0, part)),
    lambda part: Holder(FrozenDict(a=Holder(part))),
])  # fmt: skip
def test_what_can_be_changed_is_found_however_deep_it_is(put: Callable[[object], object]) -> None:
    for part in CHANGEABLE:
        assert not is_unchangeable(put(part))
        assert is_unchangeable(put(part), {id(part)})
    for part in UNCHANGEABLE:
        assert is_unchangeable(put(part))
    fixed = np.zeros(2)
    fixed.flags.writeable = False
    assert is_unchangeable(put(fixed))
