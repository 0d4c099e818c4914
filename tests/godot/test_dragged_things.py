"""While a waypoint, agent or object is dragged, the scene is what the text will compile to."""

from __future__ import annotations

import math

import numpy as np
import pytest

import roadlang
from roadlang.commands import dragged, handles_of
from roadlang.ir.scene import Scene
from roadlang_godot.editing.dragged_scene import dragged_scene


def random_text(rng: np.random.Generator) -> str:
    """A road through waypoints, agents on it and objects beside it and at places."""
    steps = rng.uniform(25, 60, 5)
    turns = np.cumsum(rng.uniform(-0.7, 0.7, 5))
    points = np.cumsum(np.column_stack([steps * np.cos(turns), steps * np.sin(turns)]), axis=0)
    listed = ", ".join(f"({x:.2f}m, {y:.2f}m)" for x, y in points)
    at, beside = rng.uniform(10, 80, 2)
    x, y = rng.uniform(-50, 50, 2)
    facing = rng.choice(["forward", "back"])
    return (
        f"road main {{ draw with waypoints {{ points: [{listed}] }}, lanes: 2 }}\n"
        f"agent ego is car on main at {at:.1f}m {{ facing: {facing}, "
        "drive with pure_pursuit { speed: 5m/s } }\n"
        f"agent walker is pedestrian at ({x:.1f}m, {y:.1f}m)\n"
        f"object elm is tree on main at {beside:.1f}m {{ side: left, offset: 6m }}\n"
        f"object kiosk is building at ({y:.1f}m, {x:.1f}m)\n"
    )


def scene_of(text: str) -> Scene:
    return roadlang.loads(text).sample(1, seed=0)[0].record


def test_a_dragged_place_of_a_road_without_waypoints() -> None:
    text = (
        "road main { draw with segments { pieces: [straight(60m), arc(80m, 40deg)] } }\n"
        "agent ego is car on main at 30m\n"
    )
    before = scene_of(text)
    handle = [handle for handle in handles_of(text, before) if handle.sort == "place"][1]
    to = (handle.x + 3.0, handle.y - 2.0)
    written = dragged(text, before, handle, to, "nudges")
    assert written is not None
    shown = dragged_scene(before, before, (text, written), handle, to)
    assert shown is not None
    (seen,), (compiled,) = shown.roads, scene_of(written).roads
    for column in ("x", "y"):
        np.testing.assert_allclose(getattr(seen, column), getattr(compiled, column), atol=0.01)


@pytest.mark.parametrize("seed", range(2))
def test_what_is_dragged_is_where_the_text_will_have_it(seed: int) -> None:
    rng = np.random.default_rng(seed)
    text = random_text(rng)
    before = scene_of(text)
    handles = handles_of(text, before)
    assert {handle.sort for handle in handles} == {"waypoint", "agent", "object"}
    for handle in handles[::2]:
        to = (handle.x + rng.uniform(-8, 8), handle.y + rng.uniform(-8, 8))
        written = dragged(text, before, handle, to, "nudges")
        assert written is not None
        shown = dragged_scene(before, before, (text, written), handle, to)
        assert shown is not None
        compiled = scene_of(written)
        if handle.sort == "waypoint":
            (seen,), (road,) = shown.roads, compiled.roads
            share = np.linspace(0.0, 1.0, 500)
            for column in ("x", "y", "curvature"):
                one, other = (
                    np.interp(share * r.length, r.stations, getattr(r, column))
                    for r in (seen, road)
                )
                np.testing.assert_allclose(one, other, atol=0.01)
            continue
        actors = [
            {actor.name: actor for actor in (*found.agents, *found.objects)}[handle.name]
            for found in (shown, compiled)
        ]
        assert math.dist(*((actor.x, actor.y) for actor in actors)) < 0.01
        one, other = (actor.heading for actor in actors)
        assert math.cos(one - other) > 0.9999, handle
