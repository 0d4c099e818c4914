"""Random scenes overlap nothing and have every agent in its lane, by their JSON alone."""

from __future__ import annotations

import json
from typing import Any

import pytest

from benchmarks.placement.checks import faults
from benchmarks.placement.random_scenes import scene_text
from roadlang import testing


def record_of(text: str, seed: int = 0) -> dict[str, Any]:
    (scene,) = testing.sample(text, 1, seed=seed)
    record: dict[str, Any] = json.loads(scene.to_json())
    return record


@pytest.mark.parametrize("number", [1, 5, 8, 13])
def test_random_scenes_are_placed_right(number: int) -> None:
    assert faults(record_of(scene_text(number), number)) == []


def test_the_check_finds_what_overlaps_and_what_is_off_its_lane() -> None:
    record = record_of("""
    road main { draw with segments { pieces: [straight(100m)] }, lanes: 2 }
    agent ego is car on main at 50m { drive with car_follow }
    agent other is car on main at 54.8m { overlap: true, lane: none, drive with car_follow }
    """)
    assert sorted(fault.split(" ")[0] for fault in faults(record)) == ["ego", "other"]
    record["agents"][0]["y"] += 1.5
    assert any("left of its road" in fault for fault in faults(record))


@pytest.mark.parametrize("row", ["agent row is car", "object row is box"])
def test_a_row_for_which_there_is_no_room_is_placed_anew_as_a_whole(row: str) -> None:
    text = f"""
    road main {{ draw with waypoints {{ points: [(0m, 0m), (160m, 0m)] }}, width: 8m }}
    agent stone is car on main at 80m
    {row} on main at random {{ count: 3, spacing: 12m }}
    """
    for scene in testing.sample(text, 8):
        things = (*scene.record.agents, *scene.record.objects)
        starts = [thing.start or 0.0 for thing in things if thing.group == "row"]
        assert starts == pytest.approx([starts[0], starts[0] + 12.0, starts[0] + 24.0])
        assert faults(json.loads(scene.to_json())) == []
