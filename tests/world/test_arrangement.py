"""Nothing overlaps, nothing stands where others drive: looked at with shapely, box by box."""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString, Polygon

from roadlang import loads
from roadlang.ir.scene import Scene, SceneActor
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]
TIGHT = 1e-4
"""Meters that a distance may be short of what is kept"""


def polygon(thing: SceneActor) -> Polygon:
    cosine, sine = math.cos(thing.heading), math.sin(thing.heading)
    corners = [(0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5), (0.5, -0.5)]
    return Polygon(
        (
            thing.x + along * thing.length * cosine - across * thing.width * sine,
            thing.y + along * thing.length * sine + across * thing.width * cosine,
        )
        for along, across in corners
    )


def random_text(seed: int) -> str:
    """A road with 5 to 60 agents and objects, most of them drawn."""
    draw = random.Random(seed)
    turn = draw.choice([-1, 1]) * draw.uniform(5, 70)
    lines = [
        "road main {\n  draw with segments { pieces: ["
        f"straight({draw.uniform(60, 150):.0f}m), arc({draw.uniform(25, 90):.0f}m, {turn:.0f}deg), "
        f"straight({draw.uniform(200, 300):.0f}m)] }}",
        f"  width: {draw.uniform(6.5, 8):.1f}m\n",
    ]
    if draw.random() < 0.5:
        lines.append("  perturb with sine { amplitude: 0m..2m, wavelength: 60m..90m }")
    lines.append("}\nagent ego is car on main at 30m { lane: -1 }")
    lines.append(f"agent lead is van on main at ego.start + ({draw.randint(9, 12)}m..30m)")
    lines.append("  { lane: -1 }")
    for number in range(draw.randint(1, 4)):
        kind = draw.choice(["car", "truck", "choice(car, bus, bicycle)", "motorcycle"])
        lane = draw.choice(
            ["lane: -1", "lane: 1", "lane: choice(-1, 1)", "lane: 1, facing: forward"]
        )
        lines.append(f"agent a{number} is {kind} on main at 0%..100%")
        lines.append(f"  {{ {lane}, count: integer(1, {draw.randint(1, 4)}) }}")
    for number in range(draw.randint(1, 3)):
        kind = draw.choice(["tree", "bush", "parked_van", "building", "choice(tree, rock, bench)"])
        side = draw.choice(["side: left", "side: right", 'side: choice("left", "right")'])
        apart = draw.choice(["", ", apart: 2m", ", heading: 0deg..360deg"])
        lines.append(f"object o{number} is {kind} on main at 0%..100%")
        lines.append(f"  {{ {side}, offset: 1m..40m, count: {draw.randint(1, 13)}{apart} }}")
    lines.append("object kiosk is building at (60m, 60m) { heading: 30deg }")
    return "\n".join(lines) + "\n"


def faults(scene: Scene) -> list[str]:
    """What stands in something else, off its lane, or in the lanes of a road."""
    found = []
    things = [*scene.agents, *scene.objects]
    shapes = [polygon(thing) for thing in things]
    for (one, a), (other, b) in itertools.combinations(zip(things, shapes, strict=True), 2):
        if a.distance(b) < 0.5 - TIGHT:
            found.append(f"{one.name} {other.name} {a.distance(b)}")
    (road,) = [road for road in scene.roads if road.derived]
    line = LineString(zip(road.x, road.y, strict=True))
    strip = line.buffer(np.mean(road.width) / 2, cap_style="flat")
    for agent, shape in zip(scene.agents, shapes, strict=False):
        assert agent.start is not None
        drawn = agent.group not in ("ego",)
        if drawn and not agent.length / 2 <= agent.start <= road.length - agent.length / 2:
            found.append(f"{agent.name} beyond the end: {agent.start}")
        if not strip.buffer(0.3).contains(shape):
            found.append(f"{agent.name} off the road")
    for thing, shape in zip(scene.objects, shapes[len(scene.agents) :], strict=True):
        if thing.road is not None and strip.intersection(shape).area > 0.05:
            found.append(f"{thing.name} on the road")
    return found


@given(st.integers(0, 10**6))
@settings(max_examples=20)
def test_random_scenes_have_room_for_everything(seed: int) -> None:
    (scene,) = loads(random_text(seed)).sample(1, seed=seed)
    assert not faults(scene.record)


@pytest.mark.slow
def test_many_random_scenes_have_room_for_everything() -> None:
    for seed in range(24):
        for scene in loads(random_text(seed)).sample(4, seed=seed):
            assert not faults(scene.record), random_text(seed)
