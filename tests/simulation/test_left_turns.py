"""Who turns left waits for oncoming traffic, so that this need not slow down."""

from __future__ import annotations

from dataclasses import replace

import pytest

from roadlang.ir.scene import Scene
from roadlang.ir.scene_junctions import SceneConnection
from roadlang.ir.trace import Trace

from .crossing_traffic import before_junction
from .routed_scenes import call, car, drive_scenes, route
from .test_traffic import scene_with


def left_and_oncoming(scene: Scene) -> tuple[SceneConnection, SceneConnection]:
    """A left turn, and the way straight on from the opposite road, to which it yields."""
    junction = scene.networks[-1].junctions[0]
    by_id = {one.id: one for one in junction.connections}
    pairs = [(by_id[one], by_id[other]) for one, other in junction.yields]
    return next(
        (left, oncoming)
        for left, oncoming in pairs
        if (left.turn, oncoming.turn) == ("left", "straight")
        and oncoming.target.road == left.source.road
    )


def driven(rule: str, distances: list[tuple[float, float]]) -> list[Trace]:
    """Drives of two cars at 13 m/s, so far from their stop lines: one turns left, one comes."""
    scene = scene_with(rule)
    ways = left_and_oncoming(scene)
    scenes = []
    for both in distances:
        agents = []
        for name, way, meters in zip(("turns", "comes"), ways, both, strict=True):
            road, lane = way.source.road, way.source.lane
            path = route(scene, road, lane, before_junction(scene, road, lane, meters), [way.turn])
            agents.append(car(scene, name, path, drive=call("traffic"), speed=13.0))
        scenes.append(replace(scene, agents=tuple(agents)))
    return drive_scenes(scenes, duration=16.0)


@pytest.mark.parametrize("rule", ["right_first", "yield"])
def test_who_turns_left_does_not_make_oncoming_traffic_brake(rule: str) -> None:
    for trace in driven(rule, [(50.0, 40.0), (50.0, 55.0), (50.0, 70.0), (50.0, 90.0)]):
        assert trace.agents["comes"].speed.min() > 12.0
        assert trace.agents["turns"].route_progress[-1] > 70.0


def test_who_turns_left_goes_first_where_oncoming_traffic_is_far_away() -> None:
    alone, before = driven("right_first", [(40.0, 15.0), (40.0, 115.0)])
    assert alone.agents["turns"].route_progress[-1] > 70.0
    turns, comes = before.agents["turns"], before.agents["comes"]
    assert turns.speed.min() > 4.0
    assert turns.route_progress[80] > 55.0
    assert comes.route_progress[80] < 115.0
