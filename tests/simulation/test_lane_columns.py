"""Lanes, limits and the edge of the road in traces of the embedded engine."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roadlang import testing
from roadlang.drive.trace_files import from_json, to_csv, to_json
from roadlang.geometry.areas.rings import outside_ring
from roadlang.ir.scene_junctions import SceneControl, SignalPhase
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.lanes.lane_columns import LANE_COLUMNS, OnRoad, corner_offsets
from roadlang.simulation.signals.lane_reader import NEEDED, LaneReader

from .crossing_traffic import before_junction, entries
from .driven_roads import drive, driven
from .followed_drives import followed
from .routed_scenes import CROSSING, car, network_scene, route

AVENUE = """
road main {
  draw with waypoints { points: [(0m, 0m), (400m, 0m)] }
  speed_limit: 50km/h
  left: [drive(3m), sidewalk(2m)]
  right: [drive(3.5m), bus(3m, speed_limit: 30km/h), sidewalk(2m)]
}
agent ego is AGENT on main at 20m { start_speed: 8m/s, drive with lane_follow { speed: 10m/s } }
"""


def on_avenue(agent: str, placed: str = "") -> str:
    return AVENUE.replace("AGENT", agent).replace("8m/s,", f"8m/s{placed},")


def test_lane_limit_and_offset_are_those_of_where_the_agent_is() -> None:
    inner = driven(on_avenue("car", ", lane: -1"))
    assert set(inner.lane) == {-1.0}
    np.testing.assert_allclose(inner.speed_limit, 50 / 3.6)
    assert np.abs(inner.lane_offset).max() < 0.1
    bus = driven(on_avenue("bus", ", lane: -2"))
    assert set(bus.lane) == {-2.0}
    np.testing.assert_allclose(bus.speed_limit, 30 / 3.6)
    assert set(bus.road) == {0.0}


def test_off_road_is_the_distance_of_the_worst_corner_from_the_edge() -> None:
    ego = driven(on_avenue("car", ", lane: -1"))
    np.testing.assert_allclose(ego.off_road, -(4.75 - ego.width / 2), atol=0.1)
    right = driven(on_avenue("car", ", lane: -2"))
    np.testing.assert_allclose(right.off_road[0], -(1.5 - right.width / 2), atol=1e-6)
    out = driven(
        """
        road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (60m, 60m)] }, width: 7m }
        agent ego is car on main at 5m {
          start_speed: 20m/s
          drive with pure_pursuit { speed: 20m/s, lateral_acceleration: 50m/s^2 }
        }
        world { friction: 0.3 }""",
        duration=12,
    )
    assert out.off_road.max() > 0.5
    assert out.off_road[0] == pytest.approx(1.75 + out.width / 2 - 3.5, abs=0.03)


@pytest.mark.parametrize("name", LANE_COLUMNS)
def test_a_column_alone_is_the_same_as_with_all_others(name: str) -> None:
    scene = testing.sample(on_avenue("bus", ", lane: -2"), 1)[0].record
    world = world_of([scene], {}, 0.02, 0.1)
    random = np.random.default_rng(5)
    columns = {needed: random.uniform(-4.0, 4.0, (1, 40)) for needed in NEEDED}
    columns["along"] = columns["station"] = random.uniform(0.0, 50.0, (1, 40))
    reader, agents = LaneReader(world), np.zeros(1, dtype=np.int64)
    alone = reader.read(agents, columns, (name,))
    assert list(alone) == [name]
    np.testing.assert_array_equal(alone[name], reader.read(agents, columns)[name])


def test_against_the_direction_of_the_road_left_is_left_of_the_agent() -> None:
    text = on_avenue("car", ", lane: 1").replace("lane_follow {", "lane_follow {")
    ego = driven(text)
    assert set(ego.lane) == {1.0}
    np.testing.assert_allclose(ego.lane_offset, ego.cross_track_error, atol=1e-9)
    assert np.diff(ego.route_progress).min() >= 0.0
    assert np.diff(ego.station).max() <= 0.0


@settings(deadline=None, max_examples=200)
@given(
    radius=st.floats(8.0, 500.0),
    offset=st.floats(-6.0, 6.0),
    error=st.floats(-3.1, 3.1),
    sign=st.sampled_from([-1.0, 1.0]),
)
def test_offsets_of_corners_are_exact_on_arcs(
    radius: float, offset: float, error: float, sign: float
) -> None:
    column = [np.array([[value]]) for value in (0.0, offset, error, sign / radius)]
    found = corner_offsets(OnRoad(*column), np.array([[4.5]]), np.array([[1.8]]))
    for place, (i, j) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        x = i * 2.25 * math.cos(error) - j * 0.9 * math.sin(error)
        y = offset + i * 2.25 * math.sin(error) + j * 0.9 * math.cos(error)
        from_center = math.hypot(x, y - sign * radius)
        assert found[place, 0, 0] == pytest.approx(sign * (radius - from_center), abs=1e-6)


def test_a_collision_keeps_the_speed_of_its_impact() -> None:
    (trace,) = drive(
        """road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] }, width: 8m }
        agent ego is car on main at 5m { drive with lane_follow { speed: 10m/s } }
        agent lead is car on main at 80m {}
        expect soft: always (ego.collision < 3m/s)"""
    )
    ego = trace.agents["ego"]
    (event,) = (event for event in trace.events if event["agent"] == "ego")
    assert event["speed"] == pytest.approx(10.0, abs=0.3)
    assert set(ego.collision[ego.time < event["time"]]) == {0.0}
    assert set(ego.collision[ego.time > event["time"] + 0.04]) == {event["speed"]}


def test_what_follows_from_poses_is_what_the_engine_records() -> None:
    text = """
    road main {
      draw with segments { pieces: [straight(60m), arc(30m, 90deg), straight(60m)] }
      width: 8m
      lanes: 2
      speed_limit: 50km/h
    }
    agent ego is car on main at 5m { drive with lane_follow { speed: 12m/s } }
    agent lead is car on main at 100m { lane: 1, drive with lane_follow { speed: 9m/s } }
    object box is barrier on main at 140m { lane: -1 }
    """
    (found,) = testing.sample(text, 1).run("builtin", duration=20, control_step=0.1)
    again = followed(found.trace, found.scene.record)
    for name, agent in found.trace.agents.items():
        if name == "box":
            continue
        for column in ("road", "lane", "lane_offset", "off_road", "speed_limit", "route_progress",
                       "station", "progress", "cross_track_error", "x", "y"):  # fmt: skip
            np.testing.assert_allclose(
                getattr(again.agents[name], column), getattr(agent, column)[: len(again.time)],
                atol=1e-3,
                err_msg=f"{name}.{column}",
            )  # fmt: skip
    assert found.trace.agents["ego"].collision[-1] > 5


def test_files_hold_the_new_columns_and_older_files_are_read() -> None:
    (trace,) = drive(on_avenue("car").replace("speed_limit: 50km/h", ""), duration=3)
    again = from_json(to_json(trace)).agents["ego"]
    ego = trace.agents["ego"]
    for name in ("road", "lane", "lane_offset", "off_road", "route_progress", "collision"):
        np.testing.assert_allclose(getattr(again, name), getattr(ego, name), err_msg=name)
    assert set(again.speed_limit) == {math.inf}
    assert "off_road" in to_csv(trace).splitlines()[0].split(",")
    old = testing.trace(testing.agent_trace(time=[0.0, 0.1], x=0, y=0))
    assert np.isnan(from_json(to_json(old)).agents["ego"].off_road).all()


def test_points_are_as_far_outside_a_ring_as_its_nearest_edge() -> None:
    ring = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 4.0), (5.0, 4.0), (5.0, 10.0), (0.0, 10.0)])
    x, y = np.array([5.0, 2.0, 12.0, 7.0, -3.0]), np.array([2.0, 5.0, 2.0, 7.0, -4.0])
    np.testing.assert_allclose(outside_ring(ring, x, y), [-2.0, -2.0, 2.0, 2.0, 5.0])


def test_signals_are_red_outside_of_the_phases_of_a_connection() -> None:
    phases = (SignalPhase((1, 2), 10.0, 3.0, 2.0), SignalPhase((3,), 5.0, 3.0, 2.0))
    control = SceneControl("signals", (), phases, offset=4.0)
    first = [
        control.light(1, time) == "red" for time in (0.0, 5.9, 6.1, 8.9, 9.1, 15.0, 20.9, 21.1)
    ]
    assert first == [False, False, False, False, True, True, True, False]
    assert control.light(3, 0.0) == "red"
    assert control.light(3, 12.0) == "green"


def test_only_agents_on_routes_need_more_than_where_they_are_along_their_roads() -> None:
    plain = world_of([testing.sample(on_avenue("car"), 1)[0].record], {}, 0.02, 0.1)
    assert set(LaneReader(plain).needed(np.array([0]))) < set(NEEDED)
    scene = network_scene(CROSSING, "lanes: 2")
    road, lane = next(iter(entries(scene)))
    way = route(scene, road, lane, before_junction(scene, road, lane, 40.0), ["left"])
    routed = world_of([replace(scene, agents=(car(scene, "ego", way),))], {}, 0.02, 0.1)
    assert LaneReader(routed).needed(np.array([0])) == NEEDED
