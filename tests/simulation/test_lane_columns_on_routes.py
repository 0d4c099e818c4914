"""Columns of agents that drive through junctions: lanes, limits, the edge, red lights."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang.ir.scene import Scene

from .routed_scenes import CROSSING, call, car, drive_scenes, network_scene, route
from .test_routes import arms, start_station

SIGNALS = "control with signals { green: 8s, yellow: 2s, all_red: 1s }"


@pytest.fixture(scope="module")
def crossing() -> Scene:
    return network_scene(CROSSING, f"lanes: 2, speed_limit: 50km/h\n{SIGNALS}")


def through(scene: Scene, turn: str, arm: int = 0) -> Scene:
    """A car from 60 m before the junction, that heeds no signals."""
    road, lane = arms(scene)[arm]
    path = route(scene, road, lane, start_station(scene, road, lane, 60.0), [turn])
    ego = car(scene, "ego", path, speed=10.0, drive=call("lane_follow", speed=10.0))
    return replace(scene, agents=(ego,))


@pytest.mark.parametrize("turn", ["left", "straight", "right"])
def test_a_turn_stays_on_the_road_and_in_its_lanes(crossing: Scene, turn: str) -> None:
    scene = through(crossing, turn)
    (trace,) = drive_scenes([scene], duration=20.0)
    ego = trace.agents["ego"]
    steps = scene.agents[0].route.steps  # type: ignore[union-attr]
    numbers = [float(next(i for i, r in enumerate(scene.roads) if r.name == s.road)) for s in steps]
    on = list(dict.fromkeys(ego.road.tolist()))
    assert on == [numbers[0], -1.0, numbers[1]]
    assert set(ego.lane[ego.road == numbers[1]]) == {float(steps[1].lane)}
    assert ego.off_road.max() < 0.3
    assert ego.off_road.min() > -8.0
    np.testing.assert_allclose(ego.speed_limit, 50 / 3.6)
    # The line that is followed leaves the middle of the lane where turns are tight.
    assert np.abs(ego.lane_offset - ego.cross_track_error).max() < 0.2
    assert ego.route_progress[-1] == pytest.approx(
        np.hypot(np.diff(ego.x), np.diff(ego.y)).sum(), rel=0.01
    )


def test_who_heeds_no_signals_crosses_stop_lines_at_red_when_they_are(crossing: Scene) -> None:
    seen = set()
    scenes = [through(crossing, "straight", arm) for arm in range(len(arms(crossing)))]
    for scene, trace in zip(scenes, drive_scenes(scenes, duration=20.0), strict=True):
        ego = trace.agents["ego"]
        step = scene.agents[0].route.steps[0]  # type: ignore[union-attr]
        turn = step.turn
        assert turn is not None
        front = ego.route_progress + ego.length / 2
        crossed = float(np.interp(abs(step.stop - step.start), front, ego.time))
        junction = next(one for one in scene.networks[-1].junctions if one.id == turn.junction)
        red = junction.control.light(turn.connection, crossed) == "red"
        expected = np.where(ego.time > crossed + 0.04, float(red), 0.0)
        certain = np.abs(ego.time - crossed) > 0.04
        np.testing.assert_array_equal(ego.red_light[certain], expected[certain])
        seen.add(red)
    assert seen == {True, False}


def test_the_bus_that_cuts_a_corner_is_off_the_road(crossing: Scene) -> None:
    scene = through(crossing, "right")
    (ego,) = scene.agents
    (trace,) = drive_scenes([replace(scene, agents=(replace(ego, length=26.0),))], duration=20.0)
    assert trace.agents["ego"].off_road.max() > 0.3


def leaving(scene: Scene, rest: float) -> Scene:
    """A car that ends its route `rest` meters on, away from the junction."""
    road, lane = arms(scene)[0]
    length = next(one.length for one in scene.roads if one.name == road)
    path = route(scene, road, -lane, rest if lane < 0 else length - rest, [])
    ego = car(scene, "ego", path, speed=10.0, drive=call("lane_follow", speed=10.0))
    return replace(scene, agents=(ego,))


def test_a_drive_is_as_far_off_the_road_whenever_others_end(crossing: Scene) -> None:
    scene = through(crossing, "right")
    (alone,) = drive_scenes([scene], duration=12.0)
    others = [leaving(crossing, float(rest)) for rest in range(35, 75, 2)]
    together = drive_scenes([scene, *others], duration=12.0)
    ends = [trace.agents["ego"].time[-1] for trace in together[1:]]
    assert min(ends) < 5.0 < 7.0 < max(ends)
    expected = alone.agents["ego"].off_road
    np.testing.assert_array_equal(together[0].agents["ego"].off_road, expected)
