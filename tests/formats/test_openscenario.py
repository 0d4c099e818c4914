"""`emit openscenario`: who stands where, what they do and when, in scenes and in drives."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree.ElementTree import Element, fromstring

import pytest

from roadlang import testing
from roadlang.cli.main import run
from roadlang.ir.scene import Scene
from roadlang_formats.emit_openscenario import OpenScenarioBackend
from roadlang_formats.openscenario.actions import assign_route
from tests.formats.opendrive_reader import ReadFile, number
from tests.formats.tool_environments import ask_tool

ROAD = "road main { draw with segments { pieces: [straight(100m), arc(60m, 90deg), straight(80m)] }, right: [drive, drive, sidewalk], left: [drive, drive], speed_limit: 36km/h }\n"  # noqa: E501
ONEWAY = ROAD.replace("left: [drive, drive]", "oneway: true").replace(
    "right: [drive, drive, sidewalk]", "lanes: 2"
)
TOWN = '''image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { lanes: 2, control with signals { green: 8s, offset: 10s } }
agent cars is choice(car, bus) on town at random { count: 3, drive with traffic }
'''
EGO = "agent ego is car on main at 20m { lane: -1, drive with car_follow%s }\n"
TRAFFIC = {
    "road": ROAD + EGO % "",
    "oncoming": ROAD + "agent ego is truck on main at 150m { facing: back }\n",
    "one-way": ONEWAY + "agent ego is motorcycle on main at 20m { lane: -1 }\n",
    "left-hand": "world { traffic: left }\n" + ROAD + EGO % "",
    "single lane": ROAD.split(", right")[0] + ", lanes: 1, width: 4m }\n"
    "agent ego is car on main at 40m { lane: -1 }\n"
    "agent back is van on main at 120m { lane: -1, facing: back }\n",
    "town": TOWN,
    "left-hand town": TOWN + "world { traffic: left }\n",
}


def written(text: str, n: int = 0, **options: str) -> tuple[Scene, Element, ReadFile]:
    scene = testing.sample(text, n + 1)[n].record
    files = OpenScenarioBackend(**options).files(scene)  # type: ignore[arg-type]
    root = fromstring(files["xosc"])
    (logic,) = root.iter("LogicFile")
    assert logic.get("filepath") == f"scene-{n:04d}.road.xodr"
    return scene, root, ReadFile.of(files["road.xodr"])


def lane_points(
    root: Element, file: ReadFile
) -> Iterator[tuple[str, tuple[float, float], Element]]:
    """Names of agents, and where the road file has the places at which they begin."""
    for private in root.iter("Private"):
        for at in private.findall(".//TeleportAction/Position/LanePosition"):
            road = file.roads[int(at.attrib["roadId"])]
            s, offset = number(at, "s"), number(at, "offset")
            x, y = road.middle(int(at.attrib["laneId"]), s)
            _, _, heading = road.pose(s)
            point = x - offset * math.sin(heading), y + offset * math.cos(heading)
            yield private.attrib["entityRef"], point, at


@pytest.mark.parametrize("name", TRAFFIC)
def test_rear_axles_stand_where_the_scene_has_them(name: str) -> None:
    scene, root, file = written(TRAFFIC[name])
    found = {agent: (point, at) for agent, point, at in lane_points(root, file)}
    assert found.keys() == {agent.name for agent in scene.agents}
    for agent in scene.agents:
        (x, y), at = found[agent.name]
        back = agent.options["wheelbase"] / 2
        wanted = agent.x - back * math.cos(agent.heading), agent.y - back * math.sin(agent.heading)
        assert (x, y) == pytest.approx(wanted, abs=0.01)
        (turn,) = at.findall("Orientation")
        assert math.remainder(number(turn, "h") - agent.heading, math.tau) == pytest.approx(
            0, abs=1e-9
        )
        (box,) = root.findall(f".//ScenarioObject[@name='{agent.name}']//Center")
        assert number(box, "x") == back


def test_things_beside_the_road_and_objects_stand_in_the_world() -> None:
    more = "agent dog is dog at (5m, 30m)\nobject oak is tree at (9m, 40m)\n"
    _, root, file = written(ROAD + more)
    places = [place.attrib for place in root.iter("WorldPosition")]
    assert [(float(p["x"]), float(p["y"])) for p in places] == [(5, 30), (9, 40)]
    assert [e.attrib["pedestrianCategory"] for e in root.iter("Pedestrian")] == ["animal"]
    assert [e.attrib["miscObjectCategory"] for e in root.iter("MiscObject")] == ["tree"]
    assert not list(file.root.iter("object"))


def test_a_lane_change_to_a_kind_of_lane_names_the_nearest_of_that_kind() -> None:
    road = ROAD.replace(
        "sidewalk], left: [drive, drive]", "parking], left: [drive, drive, parking]"
    )
    _, root, _ = written(road + EGO % "\n drive with change_lane { to: parking }\n")
    assert [element.attrib["value"] for element in root.iter("AbsoluteTargetLane")] == ["-3"]


BEHAVIORS = {
    "drive with brake { deceleration: 5m/s^2, when: ego.speed > 3m/s and time >= 2s }": (
        "2 brake",
        ["AbsoluteTargetSpeed 0"],
        ["SpeedCondition greaterThan 3", "SimulationTimeCondition greaterOrEqual 2"],
    ),
    "drive with change_lane { to: right, duration: 3s, when: distance(ego, other) < 20m }": (
        "2 lane change",
        ["RelativeTargetLane -1"],
        ["RelativeDistanceCondition lessThan 20"],
    ),
    "drive with change_lane { to: -2, distance: 30m, when: not (gap(ego, other) > 9m) }": (
        "2 lane change",
        ["AbsoluteTargetLane -2"],
        ["RelativeDistanceCondition lessOrEqual 9"],
    ),
    # 10 m/s are gone after 10 m at 5 m/s^2.
    "drive with stop_at { station: 80m, deceleration: 5m/s^2 }": (
        "2 stop",
        ["AbsoluteTargetSpeed 0"],
        ["DistanceCondition lessOrEqual 10"],
    ),
    "drive with stop_at { distance: 40m, deceleration: 5m/s^2 }": (
        "2 stop",
        ["AbsoluteTargetSpeed 0"],
        ["TraveledDistanceCondition  30"],
    ),
    "drive with speed_profile { points: [(0m, 10m/s), (30m, 5m/s)], when: ego.station > 50m }": (
        "2 speed profile",
        ["SpeedProfileEntry 10 0", "SpeedProfileEntry 5 4"],
        ["TraveledDistanceCondition  30"],
    ),
    "drive with cut_in { target: other, gap: 6m }": (
        "2 cut in",
        ["RelativeTargetLane 0", "RelativeTargetSpeed 0"],
        ["RelativeDistanceCondition greaterOrEqual 6"],
    ),
}


@pytest.mark.parametrize("controller", BEHAVIORS)
def test_controllers_become_actions_with_triggers(controller: str) -> None:
    name, does, begins = BEHAVIORS[controller]
    other = "agent other is van on main at 60m { lane: -2 }\n"
    _, root, _ = written(ROAD + other + EGO % f"\n  {controller}\n")
    (event,) = root.findall(f".//Event[@name='{name}']")
    words = ("value", "speed", "time")
    found = [
        " ".join([element.tag, *(element.attrib[word] for word in words if word in element.attrib)])
        for action in event.findall("Action")
        for element in action.iter()
        if element.tag.startswith(("AbsoluteTarget", "RelativeTarget", "SpeedProfileEntry"))
    ]
    assert [text.replace(" delta", "") for text in found] == does
    triggers = [
        f"{element.tag} {element.get('rule', '')} {float(element.attrib['value']):g}"
        for element in event.iterfind("StartTrigger//")
        if element.tag.endswith("Condition") and "value" in element.attrib
    ]
    assert triggers == begins
    assert not list(root.iter("Property"))


def test_the_nearest_of_a_group_triggers() -> None:
    others = "agent others is van on main at 60m { count: 3, spacing: 9m, lane: -2 }\n"
    for sign, sizes in (("<", [1, 1, 1]), (">", [3])):
        brake = f"\n drive with brake {{ when: distance(ego, others) {sign} 20m }}\n"
        _, root, _ = written(ROAD + others + EGO % brake)
        (trigger,) = root.findall(".//Event[@name='2 brake']/StartTrigger")
        assert [len(group.findall("Condition")) for group in trigger] == sizes


@pytest.mark.parametrize(
    ("condition", "tag", "rule", "value", "freespace"),
    [
        ("time_to_collision(ego, van) < 3s", "TimeToCollisionCondition", "lessThan", 3, "true"),
        ("time_to_collision(van, ego) <= 2s", "TimeToCollisionCondition", "lessOrEqual", 2, "true"),
        ("time_headway(ego, van) < 1.5s", "TimeHeadwayCondition", "lessThan", 1.5, "true"),
        ("4m > gap(van, ego)", "RelativeDistanceCondition", "lessThan", 4, "true"),
        ("distance(ego, van) >= 9m", "RelativeDistanceCondition", "greaterOrEqual", 9, "false"),
        ("not (9m >= distance(ego, van))", "RelativeDistanceCondition", "greaterThan", 9, "false"),
    ],
)
def test_a_condition_on_two_names_the_one_and_the_other(
    condition: str, tag: str, rule: str, value: float, freespace: str
) -> None:
    brake = f"\n drive with brake {{ when: {condition} }}\n"
    _, root, _ = written(ROAD + "agent van is van on main at 60m { lane: -2 }\n" + EGO % brake)
    (found,) = root.findall(f".//Event[@name='2 brake']/StartTrigger//{tag}")
    assert (found.get("rule"), float(found.attrib["value"])) == (rule, value)
    assert found.get("freespace") == freespace
    (first,) = root.findall(".//Event[@name='2 brake']/StartTrigger//TriggeringEntities/EntityRef")
    target = found.find("TimeToCollisionConditionTarget/EntityRef")
    second = found.get("entityRef") if target is None else target.get("entityRef")
    names = re.findall(r"ego|van", condition)
    assert [first.get("entityRef"), second] == names


def test_what_has_no_action_is_named() -> None:
    brake = "\n drive with overtake { target: van }\n drive with brake { when: ego.jerk > 1m/s^3 }"
    _, root, _ = written(ROAD + "agent van is van on main at 60m\n" + EGO % brake)
    named = [found.attrib for found in root.iter("Property")]
    assert [found["value"] for found in named] == ["overtake", "brake"]


def test_routes_are_waypoints_on_lanes() -> None:
    scene, root, file = written(TOWN)
    routes = list(root.iter("Route"))
    assert len(routes) == len(scene.agents) == 3
    for route in routes:
        lanes = [place.attrib for place in route.iter("LanePosition")]
        assert len(lanes) >= 2
        assert all(int(at["laneId"]) in file.roads[int(at["roadId"])].lane_ids() for at in lanes)


def test_a_route_is_on_one_lane_of_each_road() -> None:
    """esmini finds no way between places on two lanes of a road, and leaves out what follows."""
    text = TOWN.replace("lanes: 2", "lanes: 6").replace("count: 3", "count: 12")
    scene, root, _ = written(text)
    steps = [itertools.pairwise(agent.route.steps) for agent in scene.agents if agent.route]
    assert any(a.road == b.road and a.lane != b.lane for found in steps for a, b in found)
    routes = list(root.iter("Route"))
    assert len(routes) >= 10
    for route in routes:
        lanes = [(at.attrib["roadId"], at.attrib["laneId"]) for at in route.iter("LanePosition")]
        assert all(one == other or one[0] != other[0] for one, other in itertools.pairwise(lanes))


def test_a_route_on_roads_that_the_file_lacks_is_left_out() -> None:
    """A network that was perturbed takes the place of the one that agents are on."""
    moved = "network bent from town { perturb with sine { amplitude: 1m, wavelength: 40m } }\n"
    scene, root, _ = written(TOWN + moved)
    assert all(
        agent.route and agent.road.startswith("town/") for agent in scene.agents if agent.road
    )
    assert not list(root.iter("Route"))


def test_signals_have_the_phases_of_the_scene() -> None:
    """After 10 s of 8 s green, 3 s yellow and 1 s (or more) red, it is yellow."""
    scene, root, file = written(TOWN)
    (controller,) = root.iter("TrafficSignalController")
    phases = controller.findall("Phase")
    (control,) = (junction.control for junction in scene.networks[0].junctions)
    assert sum(number(phase, "duration") for phase in phases) == pytest.approx(control.cycle)
    ids = {signal.attrib["id"] for signal in file.root.iter("signal")}
    for phase in phases:
        states = {s.attrib["trafficSignalId"]: s.attrib["state"] for s in phase}
        assert states.keys() == ids
    first = [state.attrib["state"] for state in phases[0]]
    assert "off;on;off" in first
    assert "off;off;on" not in first


def test_the_world_of_the_scene() -> None:
    world = "world { time_of_day: 13.5h, weather: rain, rain: 7mm/h, friction: 0.5 }\n"
    _, root, _ = written(ROAD + world)
    (environment,) = root.iter("Environment")
    flat = {f"{e.tag}.{key}": text for e in environment.iter() for key, text in e.attrib.items()}
    assert flat["TimeOfDay.dateTime"].endswith("T13:30:00")
    assert float(flat["Precipitation.precipitationIntensity"]) == pytest.approx(7)
    assert flat["RoadCondition.frictionScaleFactor"] == "0.5"
    assert not list(written(ROAD)[1].iter("Environment"))


def driven(folder: Path, text: str) -> Element:
    (folder / "scene.rl").write_text(text)
    code = run(["run", str(folder / "scene.rl"), "-o", str(folder), "--duration", "12"])
    assert code == 0
    return fromstring((folder / "scene-0000.drive.xosc").read_text())


def test_drives_are_trajectories_until_agents_leave(tmp_path: Path) -> None:
    leaving = "agent ego is car on main at 200m { lane: -1, drive with car_follow }\n"
    root = driven(tmp_path, f"{ROAD}{leaving}agent post is van on main at 5m\nemit openscenario\n")
    (line,) = root.iter("Polyline")
    times = [number(vertex, "time") for vertex in line]
    assert times[0] == 0
    assert all(one < other for one, other in itertools.pairwise(times))
    assert times[-1] < 12
    (gone,) = root.findall(".//EntityAction")
    assert gone.attrib["entityRef"] == "ego"
    first = next(root.iter("Vertex")).find("Position/WorldPosition")
    assert first is not None
    file = ReadFile.of((tmp_path / "scene-0000.road.xodr").read_text())
    start = next(point for name, point, _ in lane_points(root, file) if name == "ego")
    assert (number(first, "x"), number(first, "y")) == pytest.approx(start, abs=0.01)


def test_converted_files_name_each_other(tmp_path: Path) -> None:
    (tmp_path / "scene.rl").write_text(ROAD + EGO % "")
    assert run(["convert", str(tmp_path / "scene.rl"), str(tmp_path / "a & b.xosc")]) == 0
    (logic,) = fromstring((tmp_path / "a & b.xosc").read_text()).iter("LogicFile")
    assert (tmp_path / logic.attrib["filepath"]).is_file()


@pytest.mark.slow
def test_asam_has_nothing_to_object_to(tmp_path: Path) -> None:
    """All of its rules are checked for versions 1.2 and 1.3."""
    paths = []
    texts = [*TRAFFIC.values(), *(ROAD + EGO % f"\n {c}\n" for c in BEHAVIORS if "other" not in c)]
    for version, (number_, text) in itertools.product(("1.2", "1.3"), enumerate(texts)):
        scene = testing.sample(text)[0].record
        for end, content in OpenScenarioBackend(version=version).files(scene).items():  # type: ignore[arg-type]
            folder = tmp_path / f"{version} {number_}"
            folder.mkdir(exist_ok=True)
            (folder / f"scene-0000.{end}").write_text(content)
        paths.append(str(folder / "scene-0000.xosc"))
    driven(tmp_path, f"{TOWN}emit openscenario\n")
    paths.append(str(tmp_path / "scene-0000.drive.xosc"))
    found = ask_tool("asam", "asam_openscenario.py", {"files": paths})
    assert found == [[17, []]] * len(paths)


@pytest.mark.parametrize("closed", [True, False])
def test_only_a_route_in_a_circle_is_closed(closed: bool) -> None:
    action = Element("Action")
    assign_route("tour", [], closed)(action)
    (route,) = action.iter("Route")
    assert route.get("closed") == ("true" if closed else "false")


@pytest.mark.parametrize(
    ("header", "said"),
    [
        ('scenario bend "Two cars in a bend"\n', "Two cars in a bend"),
        ("scenario bend\n", "bend"),
        ("", "scene"),
    ],
)
def test_the_header_describes_the_scene_as_far_as_it_is_named(header: str, said: str) -> None:
    _, root, _ = written(header + ROAD)
    (found,) = root.iter("FileHeader")
    assert found.attrib["description"] == said


def test_what_was_driven_needs_no_routes() -> None:
    (sample,) = testing.sample(TOWN + "simulate with builtin { duration: 0.5s }")
    text = OpenScenarioBackend().drive_files(sample.record, sample.run().trace)["drive.xosc"]
    assert "Trajectory" in str(text)
    assert not list(fromstring(text).iter("Route"))
