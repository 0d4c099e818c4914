"""An episode ends off the road where the signal `off_road` is above zero."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import roadlang
from roadlang import testing
from roadlang.envs import SceneEnv, off_road
from roadlang.envs.off_road import OffRoadCheck
from roadlang.geometry.arrays import Floats, Integers
from roadlang.ir.scene import Scene, SceneRoad
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.signals.samples import Samples
from tests.simulation.crossing_traffic import before_junction, entries
from tests.simulation.routed_scenes import CROSSING, car, network_scene, route

SIDEWALK = """
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (130m, 30m), (180m, 0m), (260m, 0m)] }
  lanes: 2, sidewalks: 2m
}
agent ego is car on main at 20m { lane: -1 }
"""
PLAIN = """
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (130m, 30m), (180m, 0m), (260m, 0m)] }
  lanes: 2
}
agent ego is car on main at 20m { lane: -1 }
"""

ONE_SIDEWALK = PLAIN.replace("lanes: 2", "left: [drive(3m)], right: [drive(3m), sidewalk(2m)]")


def on_roads(text: str) -> Scene:
    scene: Scene = testing.sample(text, 1)[0].record
    return replace(scene, agents=scene.agents * 40)


def on_routes() -> Scene:
    scene = network_scene(CROSSING, "lanes: 2")
    agents = []
    for road, lane in entries(scene):
        start = before_junction(scene, road, lane, 40.0)
        for turn in ("left", "straight", "right"):
            agents.append(car(scene, f"{road}.{turn}", route(scene, road, lane, start, [turn])))
    return replace(scene, agents=tuple(agents))


@pytest.mark.parametrize("where", [SIDEWALK, ONE_SIDEWALK, PLAIN, "routes"])
def test_who_is_off_the_road_is_what_the_signal_says(where: str) -> None:
    scene = on_routes() if where == "routes" else on_roads(where)
    world = world_of([scene], {}, 0.02, 0.1)
    off_road = OffRoadCheck(world)
    draw = np.random.default_rng(5)
    everyone = np.arange(len(world.present))
    seen: set[bool] = set()
    for _ in range(20):
        world.motion.along = draw.uniform(0.0, 0.95, len(everyone)) * world.length
        world.motion.offset = draw.uniform(-5.0, 5.0, len(everyone))
        error = draw.uniform(-0.6, 0.6, len(everyone))
        world.motion.cosine, world.motion.sine = np.cos(error), np.sin(error)
        track = world.track
        cell, rest = track.cell(world.motion.along)
        turned = track.lines.curvature[cell] * rest
        world.motion.line_heading = track.lines.heading[cell] + turned
        samples = Samples(0)
        samples.add(world, world.poses)
        expected = samples.column("off_road", everyone, 0)[0] > 0.0
        np.testing.assert_array_equal(off_road.of(world, samples, everyone), expected)
        seen |= set(expected.tolist())
    assert seen == {True, False}


@pytest.mark.parametrize("where", [SIDEWALK, PLAIN, "routes"])
def test_who_is_in_the_middle_of_its_lane_needs_no_signal(where: str) -> None:
    scene = on_routes() if where == "routes" else on_roads(where)
    world = world_of([scene], {}, 0.02, 0.1)
    everyone = np.arange(len(world.present))
    assert not OffRoadCheck(world).of(world, Samples(0), everyone).any()


def test_only_of_who_is_near_a_border_the_signal_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    world = world_of([on_roads(PLAIN)], {}, 0.02, 0.1)
    everyone = np.arange(len(world.present))
    read: list[int] = []
    now = Samples.now

    def noted(self: Samples, name: str, agents: Integers) -> Floats:
        read.extend(agents.tolist())
        return now(self, name, agents)

    monkeypatch.setattr(Samples, "now", noted)
    world.motion.offset[3] = 20.0
    samples = Samples(0)
    samples.add(world, world.poses)
    assert OffRoadCheck(world).of(world, samples, everyone).tolist() == [i == 3 for i in everyone]
    assert set(read) == {3}


def test_a_corner_off_the_road_ends_an_episode() -> None:
    env = SceneEnv(roadlang.loads(PLAIN), scenes=1)
    env.reset(seed=0)
    for _ in range(100):
        observed, _, terminated, _, info = env.step(np.array([-0.2, 0.5], dtype=np.float32))
        if terminated:
            break
    assert info["off_road"]
    seen = dict(zip(env.names, observed.tolist(), strict=True))
    assert 0.0 < seen["right_edge"] < 2.5


def test_each_road_is_measured_once(monkeypatch: pytest.MonkeyPatch) -> None:
    measured: list[SceneRoad] = []
    whole = off_road._drivable

    def noted(road: SceneRoad) -> float:
        measured.append(road)
        return whole(road)

    monkeypatch.setattr(off_road, "_drivable", noted)
    scene = on_roads(PLAIN)
    OffRoadCheck(world_of([scene, scene], {}, 0.02, 0.1))
    assert len(measured) == 1
