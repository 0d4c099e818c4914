"""How well traffic keeps to its lane in bends, and what stands beside them."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from roadlang import testing
from roadlang.geometry import Footprints, separation
from roadlang.ir.scene import Scene, SceneActor
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.observing.bend_speeds import BendSpeeds
from roadlang.simulation.state.world import World
from roadlang.simulation.surroundings.obstacles import Obstacles

from .driven_roads import drive


@pytest.mark.parametrize("radius", [25, 40, 80])
@pytest.mark.parametrize("turn", [120, -120])
def test_traffic_keeps_to_its_lane_in_a_bend(radius: int, turn: int) -> None:
    (trace,) = drive(f"""
    road pass {{
      draw with segments {{ pieces: [straight(80m), arc(radius: {radius}m, angle: {turn}deg)] }}
      lanes: 2, speed_limit: 60km/h
    }}
    agent ego is van on pass at 20m {{ drive with traffic {{ aggression: 0.8 }} }}
    """, duration=14)  # fmt: skip
    ego = trace.agents["ego"]
    bend = (ego.station > 80.0) & (ego.present > 0.0)
    assert (ego.speed[bend] ** 2 / radius).max() > 3.0
    assert np.abs(ego.cross_track_error[bend]).max() < 0.3


@given(
    station=st.floats(30.0, 44.0), left=st.floats(-4.5, 1.5), turned=st.floats(0.0, math.pi),
    length=st.floats(1.0, 8.0),
)  # fmt: skip
@example(station=36.0, left=-2.4, turned=0.3, length=6.0)
def test_a_thing_beside_a_tight_bend_is_in_the_way_where_a_rider_would_touch_it(
    station: float, left: float, turned: float, length: float
) -> None:
    scene = _bend()
    lines = world_of([scene], {}, 0.02, 0.1).track.lines
    cell = int(station / lines.spacing[0])
    heading = lines.heading[cell]
    thing = SceneActor(
        "thing", "wreck", "", float(lines.x[cell] - math.sin(heading) * left),
        float(lines.y[cell] + math.cos(heading) * left), float(heading + turned), length, 1.0, 1.0,
    )  # fmt: skip
    world = world_of([replace(scene, objects=(thing,))], {}, 0.02, 0.1)
    gap = float(Obstacles.of(world).ahead(world)[0])
    touches = _first_touch(world, thing)
    assert gap <= touches + 0.3


@cache
def _bend() -> Scene:
    (scene,) = testing.sample(
        """
        road lane {
          draw with segments {
            pieces: [straight(30m), arc(radius: 8m, angle: 90deg), straight(30m)]
          }
          lanes: 1, width: 3m
        }
        agent ego is motorcycle on lane at 5m { drive with traffic }
        """,
        1,
    )
    return scene.record


def _first_touch(world: World, thing: SceneActor) -> float:
    """How far the rider gets along its line before it touches the thing, from its front."""
    lines, along = world.track.lines, float(world.motion.along[0])
    s = lines.origin[0] + np.arange(int(lines.last[0])) * lines.spacing[0]
    ahead = (s > along) & (s < along + 60.0)
    place = np.flatnonzero(ahead)
    bodies = world.bodies
    size = np.full(len(place), bodies.length[0]), np.full(len(place), bodies.width[0])
    rider = Footprints(lines.x[place], lines.y[place], lines.heading[place], *size)
    columns = ((thing.x, thing.y, thing.heading, thing.length, thing.width),) * len(place)
    apart = separation(rider, Footprints(*np.array(columns, dtype=float).T))
    touching = np.flatnonzero(apart < 0.0)
    return float(s[place[touching[0]]]) - along if len(touching) else math.inf


def test_the_limits_of_a_bend_may_be_arrays_of_no_dimension() -> None:
    world = world_of([_bend()], {}, 0.02, 0.1)
    speeds = BendSpeeds(world)
    rows = np.arange(1)
    plain = speeds.at(world, rows, 4.5, 3.0, 10.0)
    for _ in range(2):  # a second look is compared with the first
        assert speeds.at(world, rows, np.array(4.5), np.array(3.0), 10.0) == plain
    slower = speeds.at(world, rows, np.array(1.5), np.array(3.0), 10.0)
    assert slower < plain


BLOCK = """
image plan from \"\"\"
######
#....#
#....#
######
\"\"\" { scale: 20m/px }
network town from plan { lanes: 2 }
agent ego is car on town { route: random, route_length: 800m, drive with traffic }
"""


def test_a_thing_in_the_lane_is_in_the_way_each_time_that_a_route_comes_by() -> None:
    (sampled,) = testing.sample(BLOCK, 1, seed=1)
    scene = sampled.record
    lines = world_of([scene], {}, 0.02, 0.1).track.lines
    there = int(40.0 / lines.spacing[0])
    x, y, heading = (float(column[there]) for column in (lines.x, lines.y, lines.heading))
    wreck = SceneActor("wreck", "wreck", "", x, y, heading, 4.5, 1.8, 1.5)
    world = world_of([replace(scene, objects=(wreck,))], {}, 0.02, 0.1)
    last = int(lines.last[0])
    near = np.hypot(lines.x[:last] - x, lines.y[:last] - y) < 1.0
    passes = int((np.diff(near.astype(int)) == 1).sum())
    assert passes >= 2
    assert len(Obstacles.of(world).begin) == passes


def test_riders_keep_the_balance_when_they_brake_in_a_bend() -> None:
    (trace,) = drive("""
    road pass { draw with segments { pieces: [arc(radius: 67m, angle: -90deg)] }, lanes: 2 }
    agent ego is bicycle on pass at 10m {
      start_speed: 13.5m/s
      drive with traffic { speed: 12m/s }
      drive with brake { when: time > 0.2s }
    }
    """, duration=4)  # fmt: skip
    ego = trace.agents["ego"]
    assert ego.speed[-1] < 0.1
    assert np.abs(ego.cross_track_error).max() < 0.3


@pytest.mark.parametrize("speed", [14, 25, 30])
def test_pure_pursuit_that_says_no_lookahead_stays_in_its_lane(speed: int) -> None:
    (trace,) = drive(f"""
    road pass {{
      draw with segments {{ pieces: [straight(200m), arc(300m, 60deg), arc(250m, -60deg)] }}
      lanes: 2, width: 8m
    }}
    agent ego is car on pass at 10m {{ drive with pure_pursuit {{ speed: {speed}m/s }} }}
    """, duration=70)  # fmt: skip
    ego = trace.agents["ego"]
    assert ego.off_road[ego.present > 0.0].max() < 0.0
    assert ego.progress[-1] == 1.0
