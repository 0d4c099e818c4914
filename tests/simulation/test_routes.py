"""Agents with a route follow lanes and connections through a network; what the table says of it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang.ir.scene import Scene, SceneActor
from roadlang.ir.scene_route import RouteStep, SceneRoute
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.lines.line_sources import LineSource
from roadlang.simulation.lines.route_lines import connection_points, route_line
from roadlang.simulation.state.world import World

from .routed_scenes import CROSSING, call, car, drive_scenes, network_scene, route


@pytest.fixture(scope="module")
def crossing() -> Scene:
    return network_scene(CROSSING, "lanes: 2, speed_limit: 50km/h")


BENT = """network wavy from town { perturb with sine { amplitude: 2m, wavelength: 60m } }"""


@pytest.fixture(scope="module")
def bent() -> Scene:
    return network_scene(CROSSING, "lanes: 2", network=BENT)


def arms(scene: Scene) -> list[tuple[str, int]]:
    """Roads into the only junction, with the lane that leads there."""
    (junction,) = scene.networks[-1].junctions
    return sorted({(one.source.road, one.source.lane) for one in junction.connections})


def start_station(scene: Scene, road: str, lane: int, before: float) -> float:
    found = next(one for one in scene.roads if one.name == road)
    return found.length - before if lane < 0 else before


def line_of(scene: Scene, path: SceneRoute) -> LineSource:
    numbers = {road.name: number for number, road in enumerate(scene.roads)}
    return route_line(path, scene, numbers).source


@pytest.mark.parametrize("turn", ["left", "straight", "right"])
@pytest.mark.parametrize("which", ["crossing", "bent"])
def test_the_line_of_a_route_has_no_gaps_and_no_corners(
    turn: str, which: str, request: pytest.FixtureRequest
) -> None:
    scene = request.getfixturevalue(which)
    for road, lane in arms(scene):
        line = line_of(
            scene, route(scene, road, lane, start_station(scene, road, lane, 60), [turn])
        )
        steps = np.hypot(np.diff(line.x), np.diff(line.y))
        assert np.abs(steps - np.diff(line.s)).max() < 0.02
        assert np.abs(np.diff(line.heading)).max() < 0.2
        course = np.arctan2(np.diff(line.y), np.diff(line.x))
        middle = 0.5 * (line.heading[1:] + line.heading[:-1])
        assert np.abs(np.sin(course - middle)).max() < 0.05


def test_the_points_of_a_connection_end_where_its_lane_begins(bent: Scene) -> None:
    (junction,) = bent.networks[-1].junctions
    roads = {road.name: road for road in bent.roads}
    for one in junction.connections:
        road = roads[one.target.road]
        s, x, y, _ = connection_points(one)
        is_start = one.target.end == "start"
        at = road.trim[0] if is_start else road.length - road.trim[1]
        offset = float(road.cross_section().offset(one.target.lane, at))
        heading = np.interp(at, road.stations, road.heading)
        end_x = np.interp(at, road.stations, road.x) - np.sin(heading) * offset
        end_y = np.interp(at, road.stations, road.y) + np.cos(heading) * offset
        assert s[-1] == pytest.approx(one.length)
        assert np.hypot(x[-1] - end_x, y[-1] - end_y) < 0.02


@pytest.mark.parametrize("which", ["crossing", "bent"])
def test_a_car_turns_along_its_route(which: str, request: pytest.FixtureRequest) -> None:
    scene = request.getfixturevalue(which)
    scenes = [
        replace(
            scene,
            agents=(
                car(
                    scene,
                    "ego",
                    route(scene, road, lane, start_station(scene, road, lane, 60), [turn]),
                    drive=call("lane_follow", speed=8.0),
                ),
            ),
        )
        for road, lane in arms(scene)
        for turn in ("left", "straight", "right")
    ]
    for one, trace in zip(scenes, drive_scenes(scenes, duration=40.0), strict=True):
        ego = trace.agents["ego"]
        assert np.abs(ego.cross_track_error).max() < 0.5
        assert ego.progress[-1] == 1.0
        goal = one.agents[0].route.steps[-1]
        assert ego.station[-1] == pytest.approx(goal.stop, abs=1.0)


def world_with(scene: Scene, *paths: SceneRoute) -> World:
    agents = tuple(car(scene, f"car{number}", path) for number, path in enumerate(paths))
    return world_of([replace(scene, agents=agents)], {}, 0.02, 0.1)


def test_the_table_says_where_on_roads_a_line_is(crossing: Scene) -> None:
    road, lane = arms(crossing)[0]
    path = route(crossing, road, lane, start_station(crossing, road, lane, 60.0), ["left"])
    world = world_with(crossing, path)
    first, second = path.steps
    stop = abs(first.stop - first.start)
    (turn,) = world.table.turns
    rows = np.zeros(4, dtype=np.int64)
    along = np.array([10.0, stop + 1.0, stop + turn.connection.length + 5.0, 1e4])
    place = world.table.place(rows, along)
    way, onward = (np.sign(step.stop - step.start) for step in (first, second))
    expected = [first.start + 10.0 * way, first.stop, second.start + 5.0 * onward, second.stop]
    assert place.station == pytest.approx(expected, abs=0.01)
    assert place.lane.tolist() == [first.lane, 0, second.lane, second.lane]
    assert place.step.tolist() == [0, 0, 1, 1]
    assert [crossing.roads[one].name for one in place.road] == [
        first.road, first.road, second.road, second.road,
    ]  # fmt: skip


def test_limits_ahead_are_braked_for(crossing: Scene) -> None:
    road, lane = arms(crossing)[0]
    path = route(crossing, road, lane, start_station(crossing, road, lane, 60.0), ["straight"])
    slow = replace(
        crossing,
        roads=tuple(
            replace(
                one,
                lane_list=tuple(replace(each, speed_limit=None) for each in one.lane_list),
                speed_limit=5.0 if one.name == path.steps[1].road else 20.0,
            )
            for one in crossing.roads
        ),
    )
    world = world_with(slow, path)
    begins = world.table.begin[0, 2]
    rows = np.zeros(3, dtype=np.int64)
    along = np.array([begins - 20.0, begins - 1.0, begins + 1.0])
    limits = world.table.speed_limit_ahead(rows, along, 2.0)
    assert limits == pytest.approx([np.sqrt(25.0 + 80.0), np.sqrt(25.0 + 4.0), 5.0])
    assert world.table.speed_limit(rows, along).tolist() == [20.0, 20.0, 5.0]


def test_a_route_changes_lanes_smoothly() -> None:
    scene = network_scene(CROSSING, "lanes: 4, speed_limit: 50km/h")
    road = next(one for one in scene.roads if one.name == arms(scene)[0][0])
    low, high = road.trim[0] + 1.0, road.length - road.trim[1] - 1.0
    middle = (low + high) / 2
    path = SceneRoute(
        (RouteStep(road.name, -1, low, middle), RouteStep(road.name, -2, middle, high))
    )
    line = line_of(scene, path)
    section = road.cross_section()
    first, last = section.offset(-1, low), section.offset(-2, high)
    across = np.hypot(line.x[-1] - line.x[0], line.y[-1] - line.y[0])
    assert across == pytest.approx(np.hypot(high - low, float(first - last)), abs=1e-6)
    turned = np.diff(line.heading) / np.maximum(np.diff(line.s), 1e-9)
    assert np.abs(turned).max() < 0.03
    (trace,) = drive_scenes(
        [replace(scene, agents=(car(scene, "ego", path, drive=call("lane_follow", speed=10.0)),))]
    )
    assert np.abs(trace.agents["ego"].cross_track_error).max() < 0.3


def test_cars_follow_who_is_ahead_on_another_route(crossing: Scene) -> None:
    """One stands with its rear in the lane that both leave, in another connection than the other
    will take; one stands in the lane that both enter."""
    road, lane = arms(crossing)[0]
    begin = start_station(crossing, road, lane, 60.0)
    left = route(crossing, road, lane, begin, ["left"])
    straight = route(crossing, road, lane, begin, ["straight"])
    follower = car(crossing, "ego", straight, drive=call("car_follow", speed=10.0), speed=8.0)
    for stands in (52.0, 60.0 + 12.0):
        (standing,) = _placed_along(crossing, left if stands < 60.0 else straight, [stands])
        scene = replace(crossing, agents=(follower, standing))
        (trace,) = drive_scenes([scene], duration=30.0)
        assert trace.agents["ego"].contacts.max() == 0
        assert trace.agents["ego"].speed[-1] == pytest.approx(0.0, abs=0.1)


def _placed_along(scene: Scene, path: SceneRoute, places: list[float]) -> list[SceneActor]:
    """Standing cars at arc lengths of a route."""
    line = line_of(scene, path)
    out = []
    for number, place in enumerate(places):
        x, y, heading = (float(np.interp(place, line.s, c)) for c in (line.x, line.y, line.heading))
        one = car(scene, f"standing{number}", path, drive=call("brake"))
        out.append(replace(one, x=x, y=y, heading=heading, route=None, road=None, start=None))
    return out


CORNER = "\n".join([".#" + "." * 12] * 12 + [".#############"])


def test_a_route_round_a_sharp_corner_can_be_driven_in_the_inner_lane() -> None:
    scene = network_scene(CORNER, "lanes: 2, speed_limit: 50km/h")
    (road,) = scene.roads
    for lane, ends in ((-1, (5.0, road.length - 5.0)), (1, (road.length - 5.0, 5.0))):
        path = SceneRoute((RouteStep(road.name, lane, *ends),))
        agent = car(scene, "ego", path, drive=call("lane_follow", speed=12.0))
        (trace,) = drive_scenes([replace(scene, agents=(agent,))], duration=40.0)
        assert np.abs(trace.agents["ego"].cross_track_error).max() < 0.6
        assert trace.agents["ego"].progress[-1] == 1.0
