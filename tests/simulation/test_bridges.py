"""Agents on a bridge and below it do not meet in the embedded engine; agents at a ramp do."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roadlang.api import Trace
from roadlang.geometry.areas.levels import HEADROOM, STEEPEST, are_apart
from roadlang.session.scene_set import SceneSet
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.surroundings.ray_casts import RayCaster
from tests.simulation.bridges import bridge_scenes
from tests.simulation.test_same_bytes import bytes_of, drives

EASTWARD = "route: [(-150m, 0m), (190m, 0m)]"
SOUTHWARD = "route: [(0m, 150m), (0m, -190m)]"
STAYS = "drive with traffic { go_around: false }"
FAST = "start_speed: 14m/s, drive with lane_follow { speed: 14m/s }"
MEET = f"agent below is car on town {{ {EASTWARD}, {FAST} }}\n" + (
    f"agent above is car on town {{ {SOUTHWARD}, {FAST} }}"
)
"""Two that would arrive at the crossing at the same time."""


def driven(scenes: SceneSet, seconds: float = 20.0) -> Trace:
    (drive,) = scenes.run("builtin", duration=seconds)
    return drive.trace


def test_a_car_on_a_bridge_does_not_touch_one_below(tmp_path: Path) -> None:
    for tags, contacts in (({"bridge": "yes"}, 0), ({}, 2)):
        trace = driven(bridge_scenes(tmp_path, MEET, bridge=tags))
        assert len(trace.events) == contacts


@pytest.mark.parametrize("tag", [{"bridge": "yes"}, {"tunnel": "yes"}, {"layer": "2"}])
def test_traffic_below_is_neither_a_leader_nor_somebody_to_yield_to(
    tmp_path: Path, tag: dict[str, str]
) -> None:
    """An agent drives as if the queue that stands across the other road, and who walks there, were
    not there."""
    ego = f"agent ego is car on town {{ {EASTWARD}, drive with traffic }}\n"
    queue = (
        "agent queue is truck on town { route: [(-2m, 6m), (-2m, -190m)], start_speed: 0m/s }\n"
        "agent walker is pedestrian on town at (4m, -6m) { drive with crossing { speed: 0.3m/s } }"
    )
    alone = driven(bridge_scenes(tmp_path, ego, bridge=tag)).agents["ego"]
    beside = driven(bridge_scenes(tmp_path, ego + queue, bridge=tag)).agents["ego"]
    assert np.array_equal(alone.x, beside.x)
    assert alone.speed.min() > 10.0


def test_a_bridge_has_leaders_of_its_own(tmp_path: Path) -> None:
    agents = f"agent ego is car on town {{ {SOUTHWARD}, {STAYS} }}\n" + (
        "agent broken is car on town { route: [(-2m, 0m), (0m, -190m)], start_speed: 0m/s }"
    )
    trace = driven(bridge_scenes(tmp_path, agents))
    assert not trace.events
    assert trace.agents["ego"].speed[-1] < 0.1
    assert -8.0 < trace.agents["broken"].y[-1] - trace.agents["ego"].y[-1] < -5.0


def test_who_comes_down_a_ramp_stops_behind_who_stands_at_its_end(tmp_path: Path) -> None:
    """The ramp leaves the bridge and ends at the street below."""
    agents = (
        f"agent ego is car on town {{ route: [(0m, 150m), (190m, 0m)], {STAYS} }}\n"
        "agent broken is car on town { route: [(140m, 0m), (190m, 0m)], start_speed: 0m/s }"
    )
    trace = driven(bridge_scenes(tmp_path, agents, ramp={}), 40.0)
    ego = trace.agents["ego"]
    assert not trace.events
    assert ego.speed[-1] < 0.1
    assert 125.0 < ego.x[-1] < 137.0
    assert ego.elevation.max() > HEADROOM
    assert ego.elevation[-1] == 0.0


def test_signals_of_pairs_are_infinite_between_levels(tmp_path: Path) -> None:
    agents = MEET + "\nexpect apart: always (gap(above, below) > 1m)"
    (drive,) = bridge_scenes(tmp_path, agents).run("builtin", duration=20)
    assert drive.satisfied
    (flat,) = bridge_scenes(tmp_path, agents, bridge={}).run("builtin", duration=20)
    assert not flat.satisfied


def test_conditions_do_not_see_who_is_below(tmp_path: Path) -> None:
    ego = f"agent ego is car on town {{ {SOUTHWARD}, {FAST}\n" + (
        "  drive with brake { when: distance(ego, below) < 15m }\n}\n"
    )
    below = f"agent below is car on town {{ {EASTWARD}, {FAST} }}"
    for tags, brakes in (({"bridge": "yes"}, False), ({}, True)):
        trace = driven(bridge_scenes(tmp_path, ego + below, bridge=tags), 12.0)
        assert (trace.agents["ego"].speed.min() < 13.0) == brakes


def test_rays_do_not_hit_who_is_below(tmp_path: Path) -> None:
    agents = (
        "agent ego is car on town { route: [(-2m, -1m), (0m, -190m)] }\n"
        "agent below is car on town { route: [(6m, -2m), (190m, 0m)] }"
    )
    for tags, hits in (({"bridge": "yes"}, False), ({}, True)):
        scenes = bridge_scenes(tmp_path, agents, bridge=tags)
        world = world_of([scenes[0].record], {}, 0.02, 0.1)
        rays = RayCaster(world).of(world, world.poses, np.array([0]))
        around = np.linspace(0.0, 2.0 * np.pi, 180)
        distances = rays((0.0, 0.0, 1.0), around, 0.0, 30.0)
        assert np.isfinite(distances).any() == hits


def test_a_scene_with_a_bridge_is_driven_alone_as_beside_others(tmp_path: Path) -> None:
    text = "agent cars is car on town at random { count: 8, drive with traffic }"
    records = [scene.record for scene in bridge_scenes(tmp_path, text, 2, ramp={})]
    flat = [scene.record for scene in bridge_scenes(tmp_path, text, 1, bridge={})]
    together = drives([*records, *flat], duration=15.0)
    for record, trace in zip([*records, *flat], together, strict=True):
        (alone,) = drives([record], duration=15.0)
        assert bytes_of(alone) == bytes_of(trace)
        assert heights_of(alone) == heights_of(trace)


def heights_of(trace: Trace) -> list[bytes]:
    return [agent.elevation.tobytes() for agent in trace.agents.values()]


def test_the_farther_away_the_more_may_one_be_above_another() -> None:
    above = HEADROOM + 1.0
    assert are_apart(above, 0.0)
    assert not are_apart(above, 0.0, 1.1 / STEEPEST)
    assert not are_apart(np.nan, 100.0)
