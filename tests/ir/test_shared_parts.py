"""What several scenes have in common is written once, and reads as if it were written each time."""

from __future__ import annotations

from dataclasses import replace

from roadlang.ir import json_document
from roadlang.ir.encoding import to_json
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
