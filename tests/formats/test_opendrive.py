"""`emit opendrive`, read again by a reader that is written from the standard alone."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import shapely
from shapely import LineString, MultiLineString

import roadlang
from benchmarks.formats.corpus import random_scene
from roadlang import testing
from roadlang.ir.scene import Scene
from roadlang_formats.emit_opendrive import OpenDriveBackend
from tests.formats.opendrive_reader import ReadFile, arc_length, number, polynomial, pose_of

EXAMPLES = Path(__file__).parents[2] / "examples"
CLOSE = 0.01
"""Meters by which lanes may be off."""

CROSSING = '''image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { %s }
'''
ROADS = {
    "bend": "road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (110m, 50m)] } }",
    "pieces": "road main { draw with segments { pieces: [straight(60m), clothoid(40m, 0.02/m), "
    "arc(50m, 60deg), straight(25m)] }, lanes: 3 }",
    "loop": "road main { draw with waypoints { points: [(0m, 0m), (80m, 0m), (80m, 60m), "
    "(0m, 60m)] }, closed: true }",
    "listed": "road main { draw with waypoints { points: [(0m, 0m), (90m, 20m)] }, "
    "left: [drive, bike(1.5m)], right: [drive, parking(marking: none), sidewalk(2m)] }",
    "oneway": "road main { draw with waypoints { points: [(0m, 0m), (90m, 20m)] }, lanes: 3, "
    "oneway: true, speed_limit: 90km/h }",
    "left-hand": "world { traffic: left } road main { draw with waypoints { points: [(0m, 0m), "
    "(90m, 20m)] }, lanes: 3 }".replace(" road", "\nroad"),
    "crossing": CROSSING % "lanes: 2",
    "avenues": CROSSING % "lanes: 4, sidewalks: 2m, control with signals",
    "left-hand crossing": CROSSING % "lanes: 2, control with stop" + "world { traffic: left }",
    "perturbed": CROSSING % "perturb with sine { amplitude: 2m, wavelength: 20m }",
}


@cache
def exported(text: str, **options: object) -> tuple[Scene, ReadFile]:
    """A scene of a text, and what is read of its file: both for all tests that look at them."""
    scene = testing.sample(text)[0].record
    return scene, read(scene, **options)


def read(scene: Scene, **options: object) -> ReadFile:
    return ReadFile.of(OpenDriveBackend(**options).files(scene)["xodr"])  # type: ignore[arg-type]


def middles_of(scene: Scene) -> list[np.ndarray]:
    """Points in the middles of all lanes of all roads that are built, between their trims."""
    found = []
    for road in scene.roads:
        if not road.derived:
            continue
        section, heading = road.cross_section(), np.array(road.heading)
        stations = np.array(road.stations)
        inside = (stations >= road.trim[0]) & (stations <= road.length - road.trim[1])
        for id in section.ids:
            offset = np.broadcast_to(section.offset(id, stations), stations.shape)
            points = np.column_stack(
                (
                    np.array(road.x) - offset * np.sin(heading),
                    np.array(road.y) + offset * np.cos(heading),
                )
            )
            found.append(points[inside & (section.lane_width(id, stations) > 0.1)])
    return found


def read_middles(file: ReadFile) -> MultiLineString:
    """The same lines of a file."""
    lines = []
    for road in file.roads.values():
        if road.junction == -1:
            at = np.linspace(0.0, road.length, max(2, math.ceil(road.length / 0.4)))
            lines += [[road.middle(id, float(s)) for s in at] for id in road.lane_ids() if id]
    return MultiLineString(lines)


def farthest(points: np.ndarray, lines: LineString | MultiLineString) -> float:
    """How far the farthest of the points is from the nearest line."""
    return float(shapely.distance(shapely.points(points), lines).max(initial=0.0))


@pytest.mark.parametrize("name", ROADS)
def test_lanes_lie_where_the_scene_has_them(name: str) -> None:
    scene, file = exported(ROADS[name])
    lines = read_middles(file)
    assert max(farthest(points, lines) for points in middles_of(scene)) < CLOSE


@pytest.mark.parametrize("name", ROADS)
def test_pieces_follow_each_other_without_a_gap_and_have_their_lengths(name: str) -> None:
    _, file = exported(ROADS[name])
    for road in file.roads.values():
        pieces = road.pieces()
        ends = [number(piece, "s") for piece in pieces[1:]] + [road.length]
        for piece, end in zip(pieces, ends, strict=True):
            assert number(piece, "s") + number(piece, "length") == pytest.approx(end, abs=1e-6)
            assert arc_length(piece) == pytest.approx(number(piece, "length"), abs=1e-4)
        for one, other in itertools.pairwise(pieces):
            x, y, heading = pose_of(one, number(one, "length"))
            assert math.hypot(x - number(other, "x"), y - number(other, "y")) < 1e-4
            assert abs(math.remainder(heading - number(other, "hdg"), math.tau)) < 1e-4


@pytest.mark.parametrize("name", ["crossing", "avenues", "left-hand crossing", "perturbed"])
def test_a_turn_begins_and_ends_in_the_middle_of_its_lanes(name: str) -> None:
    scene, file = exported(ROADS[name])
    turns = [road for road in file.roads.values() if road.junction != -1]
    (junction,) = scene.networks[0].junctions
    assert len(turns) == len(junction.connections) > 8
    for turn in turns:
        (lane,) = (id for id in turn.lane_ids() if id)
        for tag, s in (("predecessor", 0.0), ("successor", turn.length)):
            link = turn.element.find(f"link/{tag}")
            assert link is not None
            other = file.roads[int(link.attrib["elementId"])]
            at = 0.0 if link.attrib["contactPoint"] == "start" else other.length
            linked = turn.lane(lane).find(f"link/{tag}")
            assert linked is not None
            id = int(linked.attrib["id"])
            assert turn.middle(lane, s) == pytest.approx(other.middle(id, at), abs=1e-3)
            assert turn.width(lane, s) == pytest.approx(other.width(id, at), abs=2e-3)


@pytest.mark.parametrize(
    ("side", "left_hand"), [("right", "rule"), ("left", "rule"), ("left", "one_way_roads")]
)
def test_turns_lead_along_the_lanes_that_the_rule_of_each_road_says(
    side: str, left_hand: str
) -> None:
    """From lanes that run to the junction to lanes that run from it. Tools that do not know
    left-hand traffic drive on the right of each road all the same."""
    scene, file = exported(
        f"{CROSSING % 'lanes: 4'}world {{ traffic: {side} }}", left_hand=left_hand
    )
    on_left = (side, left_hand) == ("left", "rule")
    (junction,) = scene.networks[0].junctions
    turns = [road for road in file.roads.values() if road.junction != -1]
    assert len(turns) == len(junction.connections)
    assert {road.element.attrib["rule"] for road in file.roads.values()} == {
        "LHT" if on_left else "RHT"
    }
    for road in turns:
        (lane,) = (id for id in road.lane_ids() if id)
        for tag, contact in (("predecessor", "end"), ("successor", "start")):
            end, linked = road.element.find(f"link/{tag}"), road.lane(lane).find(f"link/{tag}")
            assert end is not None
            assert linked is not None
            runs_along = (int(linked.attrib["id"]) > 0) == on_left
            assert runs_along == (end.attrib["contactPoint"] == contact)


def test_in_left_hand_traffic_roads_whose_lanes_are_on_the_right_stay_so() -> None:
    """As those of a map of a country with right-hand traffic."""
    text = "left: [drive], right: [drive, sidewalk] }"
    main = "road main { draw with waypoints { points: [(0m, 0m), (90m, 20m)] }, " + text
    scene = testing.sample(main)[0].record
    wrong = replace(scene, world={**scene.world, "traffic": "left"})
    (road,), (same,) = (tuple(read(found).roads.values()) for found in (scene, wrong))
    assert same.element.attrib["rule"] == road.element.attrib["rule"] == "RHT"
    assert [lane.attrib for lane in same.element.iter("lane")] == [
        lane.attrib for lane in road.element.iter("lane")
    ]


def test_lanes_of_a_one_way_road_all_lie_on_the_side_of_their_traffic() -> None:
    _, file = exported(
        "road main { draw with waypoints { points: [(0m, 0m), (90m, 20m)] }, oneway: true, "
        "left: [drive(3m), bus(4m), sidewalk], right: [sidewalk] }"
    )
    (road,) = file.roads.values()
    types = {id: road.lane(id).attrib["type"] for id in road.lane_ids()}
    assert types == {1: "sidewalk", 0: "none", -1: "driving", -2: "driving", -3: "sidewalk"}
    access = {id: [child.attrib for child in road.lane(id).iter("access")] for id in types}
    only_buses = {"sOffset": "0", "rule": "allow", "restriction": "bus"}
    assert {id: found for id, found in access.items() if found} == {-1: [only_buses]}
    assert [road.width(id, 10.0) for id in (-1, -2)] == pytest.approx([4.0, 3.0])


def test_what_is_drawn_of_lines_arcs_and_clothoids_stays_so() -> None:
    _, file = exported(ROADS["pieces"])
    (road,) = file.roads.values()
    shapes = [piece[0].tag for piece in road.pieces()]
    assert shapes[0] == shapes[-1] == "line"
    assert {"spiral", "arc"} <= set(shapes)
    assert len(shapes) <= 8


@pytest.mark.parametrize("tolerance", [0.001, 0.005, 0.05])
def test_a_bent_road_takes_few_pieces_within_the_tolerance(tolerance: float) -> None:
    text = "road bent from main { perturb with sine { amplitude: 4m, wavelength: 60m } }"
    scene, file = exported(ROADS["bend"] + "\n" + text, tolerance=tolerance)
    (road,) = file.roads.values()
    assert len(road.pieces()) <= road.length / 5.0
    line = LineString([road.pose(s)[:2] for s in np.linspace(0.0, road.length, 4000)])
    (bent,) = (road for road in scene.roads if road.derived)
    assert farthest(np.column_stack((bent.x, bent.y)), line) < tolerance


def test_lights_are_switched_together_and_stand_beside_their_lanes() -> None:
    scene, file = exported(ROADS["avenues"])
    lights = [signal for signal in file.root.iter("signal") if signal.attrib["dynamic"] == "yes"]
    assert {signal.attrib["type"] for signal in lights} == {"1000001"}
    # With a value, esmini does not know them.
    assert not any("value" in signal.attrib for signal in lights)
    controlled = [
        control.attrib["signalId"] for control in file.root.iterfind("controller/control")
    ]
    assert sorted(controlled) == sorted(signal.attrib["id"] for signal in lights)
    (junction,) = file.root.iterfind("junction")
    named = {controller.attrib["id"] for controller in junction.iterfind("controller")}
    assert named == {controller.attrib["id"] for controller in file.root.iterfind("controller")}
    assert len(named) == len(scene.networks[0].junctions[0].control.phases)


def test_signs_stand_at_the_roads_that_stop() -> None:
    scene, file = exported(ROADS["left-hand crossing"])
    minor = scene.networks[0].junctions[0].control.minor
    signs = [
        (road.element.attrib["name"], sign.attrib["type"], number(sign, "t") > 0.0)
        for road in file.roads.values()
        for sign in road.element.iter("signal")
    ]
    assert {name for name, _, _ in signs} == set(minor)
    # They stand on the left of those who read them.
    assert {(kind, on_left) for _, kind, on_left in signs} == {("206", True)}


def test_objects_stand_where_the_scene_has_them() -> None:
    scene, file = exported(
        ROADS["bend"] + "\nobject trees is tree on main at random { count: 9, side: left, "
        "offset: 2m..20m }\nobject far is building at (-40m, 15m) { heading: 30deg }"
    )
    (road,) = file.roads.values()
    by_name = {element.attrib["name"]: element for element in file.root.iter("object")}
    assert len(by_name) == len(scene.objects) == 10
    for thing in scene.objects:
        element = by_name[thing.name]
        x, y, heading = road.pose(number(element, "s"))
        t = number(element, "t")
        where = np.array([x - t * math.sin(heading), y + t * math.cos(heading)])
        turned = heading + number(element, "hdg")
        corners = list(element.iterfind("outline/cornerLocal"))
        if corners:
            u, v = (np.mean([number(corner, axis) for corner in corners]) for axis in "uv")
            where += (u * math.cos(turned) - v * math.sin(turned),
                      u * math.sin(turned) + v * math.cos(turned))  # fmt: skip
            area = shapely.LinearRing(
                [[number(corner, axis) for axis in "uv"] for corner in corners]
            )
            assert area.is_ccw
            assert shapely.Polygon(area).area == pytest.approx(thing.length * thing.width, rel=1e-4)
        assert where == pytest.approx((thing.x, thing.y), abs=CLOSE)
        assert math.remainder(turned - thing.heading, math.tau) == pytest.approx(0.0, abs=1e-3)
        assert bool(corners) == (thing.name == "far")


def test_a_loop_is_three_roads_one_after_the_other() -> None:
    _, file = exported(ROADS["loop"])
    assert len(file.roads) == 3
    for road in file.roads.values():
        following = road.element.find("link/successor")
        assert following is not None
        other = file.roads[int(following.attrib["elementId"])]
        for id in (1, -1):
            ends = road.middle(id, road.length), other.middle(id, 0.0)
            assert ends[0] == pytest.approx(ends[1], abs=1e-4)


def test_heights_of_a_loop_close() -> None:
    scene = testing.sample(ROADS["loop"])[0].record
    (road,) = scene.roads
    heights = tuple(2.0 * math.sin(2.0 * math.pi * s / road.length) for s in road.stations)
    file = read(replace(scene, roads=(replace(road, elevation=heights),)))
    ends = [
        polynomial(part.element.findall("elevationProfile/elevation"), "s", s)
        for part in file.roads.values()
        for s in (0.0, part.length)
    ]
    assert ends[-1] == pytest.approx(ends[0], abs=2e-3)
    assert ends[1:-1:2] == pytest.approx(ends[2::2], abs=2e-3)


@pytest.mark.parametrize("version", ["1.6", "1.7", "1.8"])
def test_the_header_names_version_and_extent(version: str) -> None:
    _, file = exported(ROADS["bend"], version=version, geo_reference="+proj=utm +zone=32")
    header = file.root.find("header")
    assert header is not None
    assert f"{header.attrib['revMajor']}.{header.attrib['revMinor']}" == version
    assert (number(header, "west"), number(header, "east")) == pytest.approx((0.0, 110.0))
    assert header.findtext("geoReference") == "+proj=utm +zone=32"


@pytest.mark.parametrize("name", ["composed", "on_ramp", "typed_town"])
def test_examples_keep_their_lanes_and_turns(name: str) -> None:
    scene = roadlang.load(EXAMPLES / f"{name}.rl").sample(1, seed=0)[0].record
    file = read(scene)
    assert read(scene).root.attrib == file.root.attrib
    lines = read_middles(file)
    assert max(farthest(points, lines) for points in middles_of(scene)) < CLOSE


def test_a_single_lane_for_both_directions_is_two_roads_on_the_same_ground() -> None:
    """No simulator drives one lane both ways."""
    _, file = exported(ROADS["bend"].replace("] } }", "] }, lanes: 1, sidewalks: 2m }"))
    there, back = file.roads.values()
    assert [road.lane_ids() for road in (there, back)] == [[1, 0, -1, -2], [0, -1]]
    assert there.lane(-1).attrib["type"] == back.lane(-1).attrib["type"] == "driving"
    for share in (0.0, 0.3, 1.0):
        one = there.middle(-1, share * there.length)
        assert one == pytest.approx(back.middle(-1, (1.0 - share) * back.length), abs=CLOSE)


def test_a_road_from_a_junction_to_itself_is_two() -> None:
    """CARLA does not tell the ends of a road apart that are at one junction."""
    scene = random_scene("loop", 1, 0)
    file = read(scene)
    loops = [
        arm.road
        for junction in scene.networks[0].junctions
        for arm in junction.arms
        if sum(other.road == arm.road for other in junction.arms) == 2
    ]
    for junction in file.root.iterfind("junction"):
        ends = [
            (road.element.attrib["id"], tag)
            for road in file.roads.values()
            for tag in ("predecessor", "successor")
            for link in road.element.iterfind(f"link/{tag}")
            if link.attrib["elementId"] == junction.attrib["id"]
        ]
        assert len({id for id, _ in ends}) == len(ends)
    assert len(loops) == 2


def test_an_arc_that_hardly_bends_is_a_cubic() -> None:
    """CARLA finds the points of an arc from its center, in single precision."""
    _, file = exported(
        "road main { draw with segments { pieces: [straight(20m), clothoid(40m, 0.00002/m), "
        "arc(500m, 0.4deg)] } }"
    )
    shapes = [piece[0] for road in file.roads.values() for piece in road.pieces()]
    assert all(abs(number(arc, "curvature")) > 1e-5 for arc in shapes if arc.tag == "arc")


def test_stretches_of_other_surfaces_are_materials_of_their_lanes() -> None:
    patches = "surface_patches: [{ surface: ice, over: [20m, 30m], lane: -1 }]"
    text = ROADS["bend"].replace("] } }", "] }, surface: gravel, " + patches + " }")
    (road,) = exported(text)[1].roads.values()
    right, left = (
        [
            (float(found.attrib["sOffset"]), found.attrib["surface"], found.attrib["friction"])
            for found in road.lane(id).iterfind("material")
        ]
        for id in (-1, 1)
    )
    assert left == [(0.0, "gravel", "0.6")]
    assert [row[1:] for row in right] == [("gravel", "0.6"), ("ice", "0.1"), ("gravel", "0.6")]
    assert [row[0] for row in right] == pytest.approx([0.0, 20.0, 30.0], abs=CLOSE)


def test_clothoids_are_spirals_up_to_the_stations_that_they_share_with_others() -> None:
    _, file = exported(ROADS["pieces"])
    (road,) = file.roads.values()
    shapes = [(piece[0].tag, number(piece, "length")) for piece in road.pieces()]
    tags = ["line", "paramPoly3", "spiral", "paramPoly3", "arc", "line"]
    assert [tag for tag, _ in shapes] == tags
    for (tag, length), whole in zip(shapes, (60.0, 0.0, 40.0, 0.0, 52.36, 25.0), strict=True):
        assert abs(length - whole) < 1.2, tag


def test_perturbed_curves_have_a_knot_per_five_meters_at_most() -> None:
    """Turns included, and with lanes as near as others."""
    scene = random_scene("ramp", 4, 0)
    file = read(scene)
    knots = sum(len(road.pieces()) for road in file.roads.values())
    assert sum(road.length for road in file.roads.values()) / knots > 6.0
    lines = read_middles(file)
    assert max(farthest(points, lines) for points in middles_of(scene)) < CLOSE
