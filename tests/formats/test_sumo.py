"""`emit sumo`: lanes, turns, right of way, signals and vehicles, in the file and in SUMO."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from functools import cache
from pathlib import Path
from xml.etree.ElementTree import Element, fromstring

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

import roadlang
from benchmarks.formats.drives import driven_in_sumo
from roadlang import testing
from roadlang.ir.scene import Scene
from roadlang.ir.scene_route import RouteStep, RouteTurn, SceneRoute
from roadlang_formats.emit_sumo import SumoBackend
from roadlang_formats.sumo.acyclic import without_circles
from roadlang_formats.sumo.edges import GAP, road_edges
from roadlang_formats.sumo.vehicle_classes import lane_use
from tests.formats.tool_environments import tool_program

EXAMPLES = Path(__file__).parents[2] / "examples"
MAP = '''image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { %s }
agent cars is choice(car, bus, motorcycle) on town at random { count: 4, drive with traffic }
'''
LISTED = "right: [drive, bike(1.5m), sidewalk(2m)], left: [drive, bus(3.2m), parking(2m)]"
LOOP = """road main { draw with waypoints { points: [(0m, 0m), (90m, 0m), (90m, 70m), (0m, 70m)] },
  closed: true, lanes: 3 }
agent ego is car on main at 20m { lane: -1, drive with car_follow }
agent back is truck on main at 70m { facing: back, drive with car_follow }
"""
ENDING = """road before { draw with segments { pieces: [straight(150m)] }, lanes: 2, oneway: true }
road beside { draw with segments { pieces: [straight(150m)] }, lanes: 3, oneway: true }
road all from before { then: [beside, before], taper: 40m }
agent ego is car on all at 200m { lane: -3, drive with car_follow }
"""
WALKS = """road main { draw with waypoints { points: [(0m, 0m), (90m, 0m), (90m, 70m), (0m, 70m)] },
  closed: true, lanes: 2, sidewalks: 2m }
agent a is pedestrian on main at 20m { offset: 6m, drive with walk }
agent b is child on main at 30m { offset: -6m, facing: back, drive with walk { speed: 2m/s } }
agent c is pedestrian on main at 40m { offset: -6m, drive with walk }
agent d is pedestrian on main at 50m { offset: -6m }
"""
SCENES = {
    "right first": MAP % "lanes: 2",
    "signals": MAP % "lanes: 4, sidewalks: 2m, control with signals { offset: 7s, all_red: 0s }",
    "stop": MAP % "lanes: 3, control with stop",
    "all-way stop": MAP % "lanes: 2, speed_limit: 30km/h, control with all_way_stop",
    "left-hand": MAP % "lanes: 4, control with yield" + "world { traffic: left }\n",
    "listed": MAP % LISTED,
    "loop": LOOP,
    "ending lane": ENDING,
}


@cache
def written(text: str) -> tuple[Scene, Element, Element]:
    scene = testing.sample(text)[0].record
    files = SumoBackend().files(scene)
    return scene, fromstring(files["net.xml"]), fromstring(files["rou.xml"])


def edges_of(net: Element) -> dict[str, list[Element]]:
    """Lanes of all edges outside of junctions."""
    return {
        edge.attrib["id"]: edge.findall("lane")
        for edge in net.iter("edge")
        if edge.get("function") != "internal"
    }


def line_of(element: Element) -> np.ndarray:
    points = [tuple(map(float, point.split(","))) for point in element.attrib["shape"].split()]
    return np.array(points)


def turns_of(net: Element) -> list[Element]:
    return [turn for turn in net.iter("connection") if not turn.attrib["from"].startswith(":")]


@pytest.mark.parametrize("name", SCENES)
def test_every_lane_for_vehicles_is_where_the_scene_has_it(name: str) -> None:
    scene, net, _ = written(SCENES[name])
    written_lines = shapely.MultiLineString(
        [line_of(lane).tolist() for lanes in edges_of(net).values() for lane in lanes]
    )
    for road in scene.roads:
        if not road.derived:
            continue
        section, stations = road.cross_section(), np.array(road.stations)
        inside = (stations >= road.trim[0]) & (stations <= road.length - road.trim[1])
        for id in section.driving_ids():
            width = np.broadcast_to(section.lane_width(id, stations), stations.shape)
            offset = np.broadcast_to(section.offset(id, stations), stations.shape)
            x = np.array(road.x) - offset * np.sin(road.heading)
            y = np.array(road.y) + offset * np.cos(road.heading)
            used = inside & (width > 0.6 * width.max())
            points = shapely.points(np.column_stack((x, y))[used])
            assert shapely.distance(points, written_lines).max() < 0.06  # and gaps of 0.1 m


@pytest.mark.parametrize("name", SCENES)
def test_edges_are_as_long_as_their_lanes_on_the_average(name: str) -> None:
    _, net, _ = written(SCENES[name])
    for lanes in edges_of(net).values():
        driven = [lane for lane in lanes if lane.get("allow") not in ("pedestrian", "bicycle")]
        lengths = [np.hypot(*np.diff(line_of(lane), axis=0).T).sum() for lane in driven]
        assert {lane.attrib["length"] for lane in lanes} == {lanes[0].attrib["length"]}
        assert float(lanes[0].attrib["length"]) == pytest.approx(np.mean(lengths), rel=0.005)


@pytest.mark.parametrize("name", SCENES)
def test_lanes_are_counted_from_the_outer_edge(name: str) -> None:
    """Lane 1 lies left of lane 0 where traffic is on the right."""
    scene, net, _ = written(SCENES[name])
    side = -1.0 if scene.world.get("traffic") == "left" else 1.0
    assert net.get("lefthand") == ("true" if side < 0 else None)
    for lanes in edges_of(net).values():
        for outer, inner in itertools.pairwise(lanes):
            first, second = line_of(outer), line_of(inner)
            along, across = first[1] - first[0], second[0] - first[0]
            assert side * (along[0] * across[1] - along[1] * across[0]) > 0


@pytest.mark.parametrize("name", SCENES)
def test_turns_are_those_of_the_scene(name: str) -> None:
    scene, net, _ = written(SCENES[name])
    wanted = sum(len(j.connections) for network in scene.networks for j in network.junctions)
    here = [turn for turn in turns_of(net) if "." not in turn.attrib["via"]]
    assert len(here) == wanted
    lanes = {lane.attrib["id"]: lane for lane in net.iter("lane")}
    for turn in here:
        source = line_of(lanes[f"{turn.attrib['from']}_{turn.attrib['fromLane']}"])
        inside = line_of(lanes[turn.attrib["via"]])
        target = line_of(lanes[f"{turn.attrib['to']}_{turn.attrib['toLane']}"])
        assert inside[0] == pytest.approx(source[-1], abs=0.01)
        assert inside[-1] == pytest.approx(target[0], abs=0.01)


def requests_of(net: Element, kind: str) -> list[list[set[int]]]:
    """For each junction: of each link, to whom it yields and whom it can meet."""
    found = []
    for junction in net.iter("junction"):
        requests = junction.findall("request")
        count = len(requests)
        assert len(junction.attrib["intLanes"].split()) == count
        found.append([
            {n for n in range(count) if request.attrib[kind][count - 1 - n] == "1"}
            for request in requests
        ])  # fmt: skip
    return found


@pytest.mark.parametrize("name", SCENES)
def test_of_two_links_that_meet_one_yields(name: str) -> None:
    _, net, _ = written(SCENES[name])
    for yields, meets in zip(requests_of(net, "response"), requests_of(net, "foes"), strict=True):
        for number, others in enumerate(meets):
            for other in others:
                assert number in meets[other]
                both = other in yields[number], number in yields[other]
                assert both == (True, True) if name == "all-way stop" else sum(both) == 1


pairs = st.integers(0, 7).flatmap(
    lambda one: st.integers(0, 7).filter(lambda other: other != one).map(lambda n: (one, n))
)


@given(st.sets(pairs))
def test_there_is_always_somebody_who_does_not_yield(found: set[tuple[int, int]]) -> None:
    found = {pair for pair in found if pair[::-1] not in found}
    kept = without_circles(found, 8)
    assert {frozenset(pair) for pair in kept} == {frozenset(pair) for pair in found}
    left = set(range(8))
    while left:
        free = {n for n in left if not any(one == n and other in left for one, other in kept)}
        assert free
        left -= free


def test_no_edge_ends_where_it_begins() -> None:
    """netconvert takes none."""
    ring = "road ring { draw with waypoints { points: [(0m, 0m), (80m, 0m), (40m, 70m)] }, closed: true }\n"  # noqa: E501
    around = """image plan from \"\"\"
######
#....#
#....#
######
#.....
\"\"\" { scale: 20m/px }
network town from plan { lanes: 2 }
"""
    for text in (ring, around):
        _, net, _ = written(text)
        edges = [edge for edge in net.iter("edge") if edge.get("function") != "internal"]
        assert len(edges) >= 6
        assert not [edge.attrib["id"] for edge in edges if edge.get("from") == edge.get("to")]


def test_right_of_way_without_circles_is_kept() -> None:
    chain = {(2, 1), (1, 0), (2, 0), (5, 3)}
    assert without_circles(chain, 6) == chain
    assert len(without_circles({(0, 1), (1, 2), (2, 0)}, 3) & {(0, 1), (1, 2), (2, 0)}) == 2


def test_signals_show_what_those_of_the_scene_show() -> None:
    scene, net, _ = written(SCENES["signals"])
    (control,) = (junction.control for junction in scene.networks[0].junctions)
    (program,) = net.iter("tlLogic")
    (junction,) = scene.networks[0].junctions
    phases = [(float(p.attrib["duration"]), p.attrib["state"]) for p in program]
    links = {int(turn.attrib["linkIndex"]): turn for turn in turns_of(net) if turn.get("tl")}
    numbers: dict[int, set[int]] = {}
    for index, turn in links.items():
        inside = line_of(next(net.iterfind(f".//lane[@id='{turn.attrib['via']}']")))
        for connection in junction.connections:
            apart = np.hypot(*(np.array(connection.start[:2]) - inside[0]))
            if apart < 0.01 and turn.attrib["dir"] == _LETTERS[connection.turn]:
                numbers.setdefault(index, set()).add(connection.id)
    assert len(numbers) == len(links) == len(junction.connections)
    ends = np.cumsum([seconds for seconds, _ in phases])
    for time in np.arange(0.25, 70.0, 0.5).tolist():
        # SUMO begins its program `offset` seconds late.
        now = (time - float(program.attrib["offset"])) % ends[-1]
        state = phases[int(np.searchsorted(ends, now, side="right"))][1]
        for index, ids in numbers.items():
            assert state[index].lower() in {control.light(id, time)[0] for id in ids}


_LETTERS = {"left": "l", "straight": "s", "right": "r", "u": "t"}


def test_lanes_are_for_those_who_use_them() -> None:
    _, net, _ = written(SCENES["listed"].replace("choice(car, bus, motorcycle)", "bus"))
    allowed = [[lane.get("allow", "") for lane in lanes] for lanes in edges_of(net).values()]
    assert ["pedestrian", "bicycle", ""] in allowed
    assert ["authority bus emergency taxi", ""] in allowed


@pytest.mark.parametrize("name", SCENES)
def test_vehicles_depart_where_they_stand(name: str) -> None:
    scene, net, routes = written(SCENES[name])
    vehicles = {vehicle.attrib["id"]: vehicle for vehicle in routes.iter("vehicle")}
    assert vehicles.keys() == {agent.name for agent in scene.agents}
    edges = edges_of(net)
    for agent in scene.agents:
        vehicle = vehicles[agent.name]
        route = vehicle.find("route")
        assert route is not None
        assert vehicle.attrib["departLane"].isdigit()
        lane = edges[route.attrib["edges"].split()[0]][int(vehicle.attrib["departLane"])]
        line = shapely.LineString(line_of(lane))
        share = float(vehicle.attrib["departPos"]) / float(lane.attrib["length"])
        front = np.array([agent.x, agent.y]) + 0.5 * agent.length * np.array(
            [math.cos(agent.heading), math.sin(agent.heading)]
        )
        at = line.interpolate(share, normalized=True)
        assert math.hypot(at.x - front[0], at.y - front[1]) < 0.5


def test_drives_are_floating_car_data() -> None:
    (scene,) = testing.sample(LOOP)
    trace = scene.run(duration=3.0).trace
    text = SumoBackend().drive_files(scene.record, trace)["fcd.xml"]
    moments = list(fromstring(text))
    assert [float(moment.attrib["time"]) for moment in moments] == pytest.approx(trace.time)
    first = {vehicle.attrib["id"]: vehicle.attrib for vehicle in moments[0]}
    ego = scene.agents["ego"]
    assert float(first["ego"]["angle"]) == pytest.approx(90 - math.degrees(ego.heading), abs=0.5)
    assert float(first["ego"]["x"]) == pytest.approx(ego.x + 2.25 * math.cos(ego.heading), abs=0.01)


def test_who_walks_along_a_sidewalk_is_a_person_that_walks_the_way_it_faces() -> None:
    _, net, routes = written(WALKS)
    walks = {person.attrib["id"]: person.find("walk") for person in routes.iter("person")}
    edges = {name: walk.attrib["edges"].split() for name, walk in walks.items() if walk is not None}
    assert edges == {
        "a": ["-main#2", "-main#1", "-main#0"],  # against the edges that have its sidewalk
        "b": ["main#0"],
        "c": ["main#0", "main#1", "main#2"],
    }
    lanes = edges_of(net)
    for person in routes.iter("person"):
        walk = person.find("walk")
        assert walk is not None
        first, last = walk.attrib["edges"].split()[0], walk.attrib["edges"].split()[-1]
        begin, end = float(person.attrib["departPos"]), float(walk.attrib["arrivalPos"])
        assert 0.0 < begin < float(lanes[first][0].attrib["length"])
        whole = float(lanes[last][0].attrib["length"])
        assert end == (whole if person.attrib["id"] == "c" else 0.0)
    types = {kind.attrib["id"]: kind.attrib for kind in routes.iter("vType")}
    assert types["type_of_b"]["maxSpeed"] == "2.000"


@pytest.mark.slow
def test_every_trip_arrives_in_sumo(tmp_path: Path) -> None:
    sumo = tool_program("sumo", "sumo")
    texts = {**SCENES, "walks": WALKS}
    scenes = {name: testing.sample(text)[0].record for name, text in texts.items()}
    for path in sorted(EXAMPLES.glob("*.rl")):
        if path.stem in ("signals", "on_ramp", "roundabout", "network", "traffic"):
            scenes[path.stem] = roadlang.load(path).sample()[0].record
    found = {name: driven_in_sumo(sumo, scene, tmp_path) for name, scene in scenes.items()}
    assert found == {name: [] for name in scenes}


def test_nobody_departs_too_fast_to_stop_before_a_junction() -> None:
    near = MAP.split("agent")[0] % "lanes: 2" + "road arm from town { select: road(2) }\n"
    speeds = {}
    for at in ("20m", "70m"):
        agent = f"agent ego is bus on arm at {at} {{ lane: -1, start_speed: 8m/s }}\n"
        _, _, routes = written(near + agent)
        (vehicle,) = routes.iter("vehicle")
        speeds[at] = float(vehicle.attrib["departSpeed"])
    # The road ends at 82.5 m, and the front of the bus is at 76 m.
    assert speeds["20m"] == 8.0
    assert speeds["70m"] ** 2 / (2 * 3.5) + speeds["70m"] == pytest.approx(6.5, abs=0.01)


def test_a_route_may_pass_a_road_twice() -> None:
    """And lanes are changed on the way."""
    scene, _, _ = written(SCENES["loop"])
    steps = (
        RouteStep("main", -1, 20.0, 300.0),
        RouteStep("main", -2, 300.0, scene.roads[0].length, RouteTurn("", 0, 0)),
        RouteStep("main", -1, 0.0, scene.roads[0].length),
    )
    agent = replace(scene.agents[0], route=SceneRoute(steps))
    files = SumoBackend().files(replace(scene, agents=(agent,)))
    (route,) = fromstring(files["rou.xml"]).iter("route")
    assert route.attrib["edges"].split() == ["main#0", "main#1", "main#2"] * 2


def test_a_route_that_ends_where_its_last_road_begins_arrives_on_the_right_side() -> None:
    scene = testing.sample(LOOP.replace(", lanes: 3", ", lanes: 2"))[0].record
    middle = 0.5 * scene.roads[0].length
    steps = (
        RouteStep("main", 1, middle + 90.0, middle, RouteTurn("", 0, 0)),
        RouteStep("main", 1, middle, middle),
    )
    agent = replace(scene.agents[0], lane=1, start=middle + 90.0, route=SceneRoute(steps))
    files = SumoBackend().files(replace(scene, agents=(agent,)))
    (route,) = fromstring(files["rou.xml"]).iter("route")
    edges = route.attrib["edges"].split()
    assert all(edge.startswith("-main#") for edge in edges)
    assert edges[-1] == "-main#1"


def test_types_of_vehicles_have_different_names() -> None:
    scene = testing.sample(LOOP)[0].record
    agents = tuple(
        replace(agent, kind="road_van", length=length)
        for agent, length in zip(scene.agents, (4.0, 5.0), strict=True)
    )
    routes = fromstring(SumoBackend().files(replace(scene, agents=agents))["rou.xml"])
    assert [kind.attrib["id"] for kind in routes.iter("vType")] == ["road_van", "road_van_v2"]


def test_parts_of_a_road_leave_room_for_the_nodes_between_them_alone() -> None:
    """Edges end at the ends of their road, and half the length of a link before a cut."""
    scene, _, _ = written(SCENES["ending lane"])
    road = next(road for road in scene.roads if road.name == "all")
    edges = road_edges(road, ("a", "b"), False, lane_use(scene))
    assert len(edges) == 3
    assert edges[0].start == 0.0
    assert edges[-1].stop == pytest.approx(road.length)
    for before, after in itertools.pairwise(edges):
        assert after.start - before.stop == pytest.approx(GAP)
        assert before.target == after.source
