"""Stop lines: right of way and `red_light` look at the same ones."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from roadlang.ir.scene import Scene, SceneActor
from roadlang.ir.scene_route import RouteStep, RouteTurn, SceneRoute
from roadlang.ir.trace import Trace
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.junctions.signal_lights import Lights
from roadlang.simulation.junctions.stop_lines import StopLines
from roadlang.simulation.state.world import World
from roadlang.simulation.surroundings.crossed_junctions import crossings_of
from roadlang.simulation.traffic.approaches import Approaches
from roadlang.simulation.traffic.entrants import Ways
from roadlang.simulation.traffic.junction_tables import JunctionTables

from . import driven_roads
from .crossing_traffic import before_junction, entries
from .followed_drives import followed
from .routed_scenes import CROSSING, call, car, drive_scenes, lane_pose, network_scene, route

SIGNALS = "control with signals { green: 8s, yellow: 2s, all_red: 1s }"


def started(scene: Scene, *agents: SceneActor) -> World:
    return world_of([replace(scene, agents=agents)], {}, 0.02, 0.1)


@pytest.mark.parametrize(
    ("first", "second", "has_signals"),
    [("control with stop", SIGNALS, True), (SIGNALS, "control with stop", False)],
)
def test_the_control_of_a_network_made_from_another_holds_for_all_routes(
    first: str, second: str, has_signals: bool
) -> None:
    derived = f"network city from town {{ {second} }}"
    scene = network_scene(CROSSING, f"lanes: 2\n{first}", network=derived)
    town = replace(scene, networks=scene.networks[:1])
    road, lane = entries(town)[0]
    path = route(town, road, lane, before_junction(town, road, lane, 40.0), ["straight"])
    world = started(scene, car(scene, "ego", path))
    crossings = crossings_of(world)
    (junction,) = crossings.junctions
    assert junction is scene.networks[1].junctions[0]
    assert world.stop_lines.is_empty is not has_signals
    if has_signals:
        np.testing.assert_array_equal(
            world.stop_lines.along, np.where(crossings.junction >= 0, crossings.stop, math.inf)
        )


def without_route(scene: Scene, distance: float) -> SceneActor:
    """A car on a road that ends at the junction, that heeds no signals."""
    road, lane = entries(scene)[0]
    start = before_junction(scene, road, lane, distance)
    path = route(scene, road, lane, start, ["straight"])
    actor = car(scene, "ego", path, speed=10.0, drive=call("lane_follow", speed=10.0))
    found = next(one for one in scene.roads if one.name == road)
    x, y, _, offset = lane_pose(found, lane, start)
    return replace(actor, route=None, x=x, y=y, heading=actor.heading, offset=offset)


def drive(scene: Scene, agents: Sequence[SceneActor]) -> Trace:
    (trace,) = drive_scenes([replace(scene, agents=tuple(agents))], duration=12.0)
    return trace


def reds(scene: Scene) -> list[float]:
    """Offsets of the signals with which the junction shows red to all when a car comes."""
    cycle = scene.networks[0].junctions[0].control.cycle
    return [cycle * share for share in (0.0, 0.25, 0.5, 0.75)]


def with_offset(scene: Scene, offset: float) -> Scene:
    (network,) = scene.networks
    junctions = tuple(
        replace(one, control=replace(one.control, offset=offset)) for one in network.junctions
    )
    return replace(scene, networks=(replace(network, junctions=junctions),))


def test_red_lights_are_counted_on_roads_that_end_at_a_junction_without_a_route() -> None:
    scene = network_scene(CROSSING, f"lanes: 2\n{SIGNALS}")
    seen = set()
    for offset in reds(scene):
        shown = with_offset(scene, offset)
        ego = without_route(shown, 30.0)
        trace = drive(shown, [ego])
        world = started(shown, ego)
        stop = float(world.stop_lines.along[0].min())
        agent = trace.agents["ego"]
        front = world.motion.along[0] + agent.route_progress + 0.5 * agent.length
        assert front[-1] > stop + 1.0
        crossed = float(np.interp(stop, front, agent.time))
        number = world.stop_lines.connection[0, world.stop_lines.along[0].argmin()]
        red = world.stop_lines.lights.is_red(np.array([number]), np.array([crossed]))[0]
        assert agent.red_light[-1] == float(red)
        again = followed(trace, replace(shown, agents=(ego,))).agents["ego"]
        np.testing.assert_array_equal(again.red_light, agent.red_light[: len(again.time)])
        seen.add(bool(red))
    assert seen == {True, False}


def always_red() -> Lights:
    (junction,) = network_scene(CROSSING, f"lanes: 2\n{SIGNALS}").networks[0].junctions
    phases = tuple(replace(one, connections=()) for one in junction.control.phases)
    return Lights.of([replace(junction, control=replace(junction.control, phases=phases))])


@pytest.mark.parametrize(
    ("front", "stop", "crosses"),
    [
        (99.5, 0.25, True),  # the seam of the lap lies between
        (99.5, 0.75, False),
        (100.5, 0.75, True),  # the middle of the car has not passed the seam yet
        (100.5, 0.25, False),
        (99.5, 0.0, True),
        (50.0, 50.5, True),
    ],
)
def test_a_stop_line_after_the_seam_of_a_lap_is_crossed_once(
    front: float, stop: float, crosses: bool
) -> None:
    lines = StopLines(np.array([[stop, math.inf]]), np.zeros((1, 2), dtype=np.int64), always_red())
    one, step = np.zeros(1, dtype=np.int64), np.array([1.0])
    span = (np.array([0.0]), 0.1)
    lap = np.array([100.0])
    found = lines.crossed_at_red(one, np.array([front]), step, lap, span)
    assert found.tolist() == [crosses]


RING = "\n".join(["." * 9, ".#######."] + [".#.....#."] * 5 + [".#######."] + ["....#...."] * 6)
"""A ring with a road that leaves it: its only junction is where the ring begins and ends."""


def round_trip(scene: Scene) -> SceneRoute:
    """The ring, from the junction back to it, again and again."""
    (network,) = scene.networks
    for junction in network.junctions:
        for one in junction.connections:
            if one.source.road == one.target.road and one.turn != "u":
                road = next(found for found in scene.roads if found.name == one.source.road)
                ends = road.trim[0], road.length - road.trim[1]
                start, stop = ends if one.source.end == "end" else ends[::-1]
                turn = RouteTurn(network.name, junction.id, one.id)
                step = RouteStep(road.name, one.source.lane, start, stop, turn)
                return SceneRoute((step,), closed=True)
    raise AssertionError("no way round")


def test_a_car_leaves_the_junction_at_the_seam_of_its_lap_with_its_rear() -> None:
    scene = network_scene(RING, "lanes: 2\ncontrol with signals")
    world = started(scene, car(scene, "ego", round_trip(scene)))
    crossings = crossings_of(world)
    (stop,), (leave,) = crossings.stop[0], crossings.exit[0]
    assert leave == world.length[0]
    np.testing.assert_array_equal(world.stop_lines.along, crossings.stop)
    tables, lights = JunctionTables.of(crossings.junctions), Lights.of(crossings.junctions)
    half = 0.5 * world.bodies.length[0]
    for past in (-0.5, 0.5, half + 0.5):
        world.motion.along[0] = past % leave
        ways = Ways.of(np.array([0]), crossings, world.bodies, tables, lights)
        near = Approaches.of(world, ways)
        inside = past < half
        assert near.is_behind.tolist() == [[not inside]]
        to_stop = stop - past - half if not inside else stop - leave - past - half
        assert near.to_line[0, 0] == pytest.approx(to_stop)


def test_two_who_have_waited_for_long_do_not_both_let_the_other_merge_first() -> None:
    """They turn into the same lane from opposite sides, after a column on the main road."""
    text = '''
    image plan from """
    .....#.....
    .....#.....
    .....#.....
    ###########
    .....#.....
    .....#.....
    .....#.....
    """ { scale: 15m/px, legend: { "#": road } }
    network town from plan { lanes: 2, speed_limit: 50km/h, control with yield }
    agent column is car on town at (96m, 54m) {
      count: 6, spacing: -11.5m, route: [(4m, 54m)]
      drive with traffic { speed: 3m/s, politeness: 0 }
    }
    agent right is car on town {
      route: [(80m, 68m), (4m, 54m)], start_speed: 0, drive with traffic { politeness: 1 }
    }
    agent left is car on town {
      route: [(85m, 18m), (4m, 54m)], start_speed: 0, drive with traffic { politeness: 1 }
    }
    '''
    (trace,) = driven_roads.drive(text, duration=50.0)
    assert trace.events == ()
    assert all(trace.agents[name].x.min() < 60.0 for name in ("right", "left"))
