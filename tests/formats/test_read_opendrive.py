"""`read with opendrive`: roads, lanes and junctions of small files."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import roadlang
from roadlang import testing
from roadlang.geometry import CrossSection, Curve, Edge, RoadNetwork
from roadlang.ir.scene import Scene
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_formats.read_opendrive import OpenDriveMap
from tests.formats.opendrive_reader import ReadFile, pose_of
from tests.formats.small_maps import (
    TWO_WAY,
    crossing,
    lane,
    link,
    linked,
    piece,
    road,
    section,
    straight,
    xodr,
)

Read = Callable[[str], RoadNetwork]
CLOSE = 0.002
"""Meters by which points of the reference line may be off."""


@pytest.fixture
def read(tmp_path: Path) -> Callable[[str], RoadNetwork]:
    def read(text: str) -> RoadNetwork:
        path = tmp_path / "town.xodr"
        path.write_text(text)
        network: RoadNetwork = OpenDriveMap().read(path).network
        return network

    return read


def lanes_of(edge: Edge) -> CrossSection:
    assert edge.cross_section is not None
    return edge.cross_section


def sampled(tmp_path: Path, text: str, scenario: str = "") -> Scene:
    path = tmp_path / "town.xodr"
    path.write_text(text)
    return testing.sample(f'network town from "{path}" {scenario}')[0].record


SHAPES = {
    "line": "<line/>",
    "arc": '<arc curvature="0.02"/>',
    "spiral": '<spiral curvStart="0.0" curvEnd="-0.03"/>',
    "paramPoly3": '<paramPoly3 pRange="normalized" aU="0" bU="50" cU="0" dU="-2" '
    'aV="0" bV="0" cV="9" dV="-3"/>',
}


@pytest.mark.parametrize("shape", SHAPES)
def test_each_kind_of_piece_is_where_the_file_has_it(read: Read, shape: str) -> None:
    network = read(xodr(road(7, 50.0, piece(0, 20, -5, 0.7, 50.0, SHAPES[shape]))))
    (edge,) = network.edges
    element = ReadFile.of(xodr(road(7, 50.0, piece(0, 20, -5, 0.7, 50.0, SHAPES[shape]))))
    (geometry,) = element.roads[7].pieces()
    for s in np.linspace(0.0, 50.0, 21):
        x, y, _ = pose_of(geometry, float(s))
        at, across = edge.curve.project([[x, y]])
        beyond = math.dist((x, y), edge.curve.at(at)[0])
        assert abs(float(across[0])) < CLOSE, (s, beyond)


def test_a_poly3_is_a_function_of_its_own_axis(read: Read) -> None:
    shape = '<poly3 a="0" b="0" c="0.01" d="-0.0001"/>'
    (edge,) = read(xodr(road(1, 50.0, piece(0, 0, 0, 0.0, 50.0, shape)))).edges
    u = np.linspace(0.0, 45.0, 40)
    points = np.column_stack((u, 0.01 * u**2 - 0.0001 * u**3))
    assert np.abs(edge.curve.project(points)[1]).max() < CLOSE
    assert edge.length == pytest.approx(50.0, abs=1e-3)


def test_a_paramPoly3_by_arc_length_has_the_length_of_the_file(read: Read) -> None:
    shape = (
        '<paramPoly3 pRange="arcLength" aU="0" bU="1" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0"/>'
    )
    (edge,) = read(xodr(road(1, 33.0, piece(0, 0, 0, 0.0, 33.0, shape)))).edges
    assert edge.length == pytest.approx(33.0)
    assert edge.curve.at(33.0) == pytest.approx([33.0, 0.0])


def test_pieces_follow_one_another(read: Read) -> None:
    pieces = piece(0, 0, 0, 0.0, 30.0) + piece(30, 30, 0, 0.0, 20.0, '<arc curvature="0.05"/>')
    (edge,) = read(xodr(road(1, 50.0, pieces))).edges
    assert edge.length == pytest.approx(50.0, abs=1e-4)
    assert edge.curve.at(50.0) == pytest.approx(
        [30 + 20 * math.sin(1.0), 20 * (1 - math.cos(1.0))], abs=1e-4
    )


def test_roads_keep_their_ids_and_names(read: Read) -> None:
    network = read(xodr(straight(17, 0, 0, name="High Street"), straight(4, 0, 50)))
    assert [(edge.id, edge.name) for edge in network.edges] == [(17, "High Street"), (4, "")]


def test_ids_that_are_words_become_names(read: Read) -> None:
    network = read(xodr(straight("north", 0, 0), straight("south", 0, 50)))
    assert [(edge.id, edge.name) for edge in network.edges] == [(0, "north"), (1, "south")]


def test_lanes_have_their_types_widths_and_directions(read: Read) -> None:
    lanes = section(
        0,
        [lane(2, 2.0, "sidewalk"), lane(1, 3.0)],
        [lane(-1, 3.5), lane(-2, 1.5, "biking")],
    )
    (edge,) = read(xodr(straight(1, 0, 0, lanes=lanes))).edges
    found = lanes_of(edge)
    assert [(lane.id, lane.kind, lane.direction) for lane in found.lanes] == [
        (2, "sidewalk", "both"),
        (1, "drive", "backward"),
        (-1, "drive", "forward"),
        (-2, "bike", "forward"),
    ]
    assert found.border_offsets(30.0) == pytest.approx([5.0, 3.0, 0.0, -3.5, -5.0])


def test_in_left_hand_traffic_lanes_on_the_left_run_along_the_road(tmp_path: Path) -> None:
    text = xodr(straight(1, 0, 0).replace("<road ", '<road rule="LHT" '))
    path = tmp_path / "town.xodr"
    path.write_text(text)
    found = OpenDriveMap().read(path)
    assert [lane.direction for lane in lanes_of(found.network.edges[0]).lanes] == [
        "forward",
        "backward",
    ]
    assert "traffic: left" in found.remarks[0]


def test_widths_and_offsets_are_cubics(read: Read) -> None:
    width = '<width sOffset="0" a="3" b="0" c="0.003" d="-0.00004"/>'
    offset = '<laneOffset s="0" a="0" b="0" c="0.002" d="0"/>'
    lanes = offset + section(0, [lane(1)], [lane(-1, width)])
    (edge,) = read(xodr(straight(1, 0, 0, lanes=lanes))).edges
    s = np.linspace(0.0, 60.0, 61)
    borders = lanes_of(edge).border_offsets(s)
    assert borders[1] == pytest.approx(0.002 * s**2, abs=0.003)
    assert borders[1] - borders[2] == pytest.approx(3 + 0.003 * s**2 - 0.00004 * s**3, abs=0.003)


def test_borders_are_widths_of_lanes_without_them(read: Read) -> None:
    borders = '<border sOffset="0" a="{}" b="0" c="0" d="0"/>'
    right = [lane(-1, borders.format(-3.0)), lane(-2, borders.format(-7.0))]
    (edge,) = read(xodr(straight(1, 0, 0, lanes=section(0, (), right)))).edges
    assert lanes_of(edge).border_offsets(10.0) == pytest.approx([0.0, -3.0, -7.0])


def test_a_lane_of_one_section_has_no_width_in_the_others(read: Read) -> None:
    """The new lane is between the two that go on: links say so, not the ids."""
    lanes = section(
        0, (), [lane(-1, inside=linked(None, -1)), lane(-2, 2.0, inside=linked(None, -3))]
    ) + section(
        30,
        (),
        [
            lane(-1, inside=linked(-1)),
            lane(-2, 3.0),
            lane(-3, 2.0, inside=linked(-2)),
        ],
    )
    (edge,) = read(xodr(straight(1, 0, 0, lanes=lanes))).edges
    section_ = lanes_of(edge)
    assert section_.ids == (-1, -2, -3)
    assert [float(section_.lane_width(id, 20.0)) for id in (-1, -2, -3)] == [3.5, 0.0, 2.0]
    assert [float(section_.lane_width(id, 40.0)) for id in (-1, -2, -3)] == [3.5, 3.0, 2.0]
    assert float(section_.lane_width(-2, 29.9)) == 0.0


def test_speed_limits_are_meters_per_second(read: Read) -> None:
    limit = '<type s="0" type="town"><speed max="30" unit="mph"/></type>'
    own = '<speed sOffset="0" max="50" unit="km/h"/>'
    lanes = section(0, [lane(1)], [lane(-1).replace("<roadMark", own + "<roadMark")])
    (edge,) = read(xodr(straight(1, 0, 0, lanes=lanes, inside=limit))).edges
    limits = {lane.id: lane.speed_limit for lane in lanes_of(edge).lanes}
    assert limits == {1: pytest.approx(13.4112), -1: pytest.approx(50 / 3.6)}


def test_heights_and_origin_are_kept(tmp_path: Path) -> None:
    profile = '<elevationProfile><elevation s="0" a="5" b="0.1" c="0" d="0"/></elevationProfile>'
    header = "<geoReference><![CDATA[+proj=tmerc +lat_0=48.1 +lon_0=11.5]]></geoReference>"
    scene = sampled(tmp_path, xodr(straight(1, 0, 0, inside=profile), header=header))
    (found,) = scene.roads
    assert found.elevation[0] == pytest.approx(5.0)
    assert found.elevation[-1] == pytest.approx(11.0)
    assert scene.networks[0].origin == (48.1, 11.5)
    again = sampled(tmp_path, OpenDriveBackend().files(scene)["xodr"])
    assert again.networks[0].origin == (48.1, 11.5)


def turns_of(scene: Scene) -> set[tuple[str, int, str, int]]:
    """Roads and lanes of all connections."""
    return {
        (c.source.road, c.source.lane, c.target.road, c.target.lane)
        for network in scene.networks
        for junction in network.junctions
        for c in junction.connections
    }


CROSSING_TURNS = {
    ("town/1", -1, "town/2", -1),
    ("town/2", 1, "town/1", 1),
    ("town/1", -1, "town/3", 1),
    ("town/3", -1, "town/2", -1),
}


def test_a_junction_has_the_turns_of_the_file_and_no_others(tmp_path: Path) -> None:
    scene = sampled(tmp_path, crossing())
    assert turns_of(scene) == CROSSING_TURNS
    (junction,) = scene.networks[0].junctions
    assert {road.trim for road in scene.roads} == {(0.0, 0.0)}
    assert [arm.road for arm in junction.arms] != []


def test_turns_follow_the_lines_of_the_file(tmp_path: Path) -> None:
    """The right turn is a quarter of a circle of 10 m whose lane lies 1.75 m inside of it."""
    scene = sampled(tmp_path, crossing())
    (junction,) = scene.networks[0].junctions
    right = next(c for c in junction.connections if c.target.road == "town/3")
    assert right.turn == "right"
    ((length, curvature),) = right.pieces
    assert curvature == pytest.approx(-1 / 8.25, rel=1e-4)
    assert length == pytest.approx(8.25 * math.pi / 2, rel=1e-4)


def test_perturbed_roads_keep_meeting_at_their_junctions(tmp_path: Path) -> None:
    scene = sampled(
        tmp_path, crossing(), "{ perturb with sine { amplitude: 3m, wavelength: 30m } }"
    )
    (junction,) = scene.networks[0].junctions
    roads = {road.name: road for road in scene.roads}
    assert turns_of(scene) == CROSSING_TURNS
    assert max(np.abs(road.curvature).max() for road in scene.roads) > 0.01
    for connection in junction.connections:
        source = roads[connection.source.road]
        place = 0 if connection.source.end == "start" else -1
        offset = float(
            source.cross_section().offset(connection.source.lane, source.stations[place])
        )
        x = source.x[place] - offset * math.sin(source.heading[place])
        y = source.y[place] + offset * math.cos(source.heading[place])
        assert math.dist((x, y), connection.start[:2]) < 1e-6


def test_a_map_that_is_written_and_read_again_is_the_same(tmp_path: Path) -> None:
    scene = sampled(tmp_path, crossing())
    again = sampled(tmp_path, OpenDriveBackend().files(scene)["xodr"])
    assert turns_of(again) == CROSSING_TURNS
    for one, other in zip(scene.roads, again.roads, strict=True):
        curve = Curve.hermite(np.column_stack((other.x, other.y)), other.heading)
        assert np.abs(curve.project(np.column_stack((one.x, one.y)))[1]).max() < CLOSE


def test_roads_that_follow_one_another_are_joined_lane_by_lane(tmp_path: Path) -> None:
    first = straight(1, 0, 0, inside=link(successor="road 2 start"))
    second = straight(2, 60, 0, inside=link(predecessor="road 1 end"))
    scene = sampled(tmp_path, xodr(first, second))
    (joint,) = scene.networks[0].junctions
    assert joint.kind == "joint"
    assert turns_of(scene) == {("town/1", -1, "town/2", -1), ("town/2", 1, "town/1", 1)}


def test_roads_against_one_another_change_the_signs_of_lanes(tmp_path: Path) -> None:
    first = straight(1, 0, 0, inside=link(successor="road 2 end"))
    back = road(
        2, 60.0, piece(0, 120, 0, math.pi, 60.0), TWO_WAY, inside=link(successor="road 1 end")
    )
    scene = sampled(tmp_path, xodr(first, back))
    assert turns_of(scene) == {("town/1", -1, "town/2", 1), ("town/2", -1, "town/1", 1)}


def test_agents_drive_through_a_map(tmp_path: Path) -> None:
    (tmp_path / "town.xodr").write_text(crossing())
    text = (
        f'network town from "{tmp_path}/town.xodr"\n'
        "agent ego is car on town at random { drive with pure_pursuit { speed: 8m/s } }\n"
    )
    (ego,) = testing.sample(text)[0].record.agents
    assert ego.road in ("town/1", "town/2", "town/3")


def test_a_road_of_a_map_is_selected_by_its_id(tmp_path: Path) -> None:
    (tmp_path / "town.xodr").write_text(crossing())
    text = f'network town from "{tmp_path}/town.xodr"\nroad main from town {{ select: road(3) }}\n'
    main = next(road for road in testing.sample(text)[0].record.roads if road.name == "main")
    assert (main.x[0], main.y[0]) == pytest.approx((0.0, -50.0))


FAULTS = {
    "no number": (straight(1, 0, 0).replace('length="60.0"><line', 'length="6O"><line'), "6O"),
    "not finite": (straight(1, 0, 0).replace('x="0"', 'x="nan"'), "nan"),
    "no pieces": (road(1, 60.0, ""), "planView"),
    "no length": (road(1, 1e-9, piece(0, 0, 0, 0.0, 60.0)), "road `1` is too short"),
    "no lanes": (straight(1, 0, 0, lanes=""), "no lane"),
    "a gap": (
        road(1, 60.0, piece(0, 0, 0, 0.0, 30.0) + piece(30, 35, 0, 0.0, 30.0)),
        "5 m away",
    ),
    "twice": (straight(1, 0, 0) + "\n" + straight(1, 0, 9), "two roads"),
    "nowhere": (straight(1, 0, 0, inside=link(successor="road 8 start")), "road `8`"),
    "lane 2 alone": (straight(1, 0, 0, lanes=section(0, (), [lane(-2)])), "no lane -1"),
    "contact": (straight(1, 0, 0, inside=link(successor="road 1 middle")), "contactPoint"),
    "a vortex": (
        road(1, 90000.0, piece(0, 0, 0, 0.0, 90000.0, '<arc curvature="90"/>')),
        "turns too often",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_are_reported_with_their_lines(tmp_path: Path, fault: str) -> None:
    element, word = FAULTS[fault]
    path = tmp_path / "town.xodr"
    path.write_text(xodr("", element))
    with pytest.raises(roadlang.DiagnosticError) as caught:
        OpenDriveMap().read(path)
    (found,) = caught.value.diagnostics
    assert found.span is not None
    assert (found.code, found.span.source.path) == ("RL479", "town.xodr")
    assert found.span.line == (6 if fault == "twice" else 5)
    assert word in found.message


def test_a_file_cut_off_is_reported_where_it_ends(tmp_path: Path) -> None:
    path = tmp_path / "town.xodr"
    path.write_text(crossing()[:1500])
    with pytest.raises(roadlang.DiagnosticError) as caught:
        OpenDriveMap().read(path)
    place = caught.value.diagnostics[0].span
    assert place is not None
    assert place.start >= 1400


def test_entities_are_refused_before_they_grow(tmp_path: Path) -> None:
    names = "abcdefghij"
    bomb = '<!DOCTYPE x [<!ENTITY a "lol">' + "".join(
        f'<!ENTITY {after} "{f"&{before};" * 10}">' for before, after in pairwise(names)
    )
    path = tmp_path / "town.xodr"
    path.write_text(f'<?xml version="1.0"?>\n{bomb}]>\n<OpenDRIVE>&j;</OpenDRIVE>')
    with pytest.raises(roadlang.DiagnosticError, match="entity `a`"):
        OpenDriveMap().read(path)


def test_links_to_roads_that_are_elsewhere_join_nothing(tmp_path: Path) -> None:
    far = straight(1, 0, 0, inside=link(successor="road 2 start")), straight(2, 160, 0)
    path = tmp_path / "town.xodr"
    path.write_text(xodr(*far))
    found = OpenDriveMap().read(path)
    assert found.network.junctions == ()
    assert found.remarks == (
        "road 1 (line 4) leads to road 2, which is 100 m away: they are not joined",
    )


def test_a_lane_shorter_than_the_stations_are_apart_is_no_fault(tmp_path: Path) -> None:
    short = section(20.2, [lane(1)], [lane(-1), lane(-2, 2.0, "shoulder")])
    lanes = TWO_WAY + short + section(20.7, [lane(1)], [lane(-1)])
    scene = sampled(tmp_path, xodr(straight(1, 0, 0, lanes=lanes)))
    widths = {found.id: np.max(found.width) for found in scene.roads[0].lane_list}
    assert widths == pytest.approx({1: 3.5, -1: 3.5, -2: 0.0}, abs=1e-5)


def test_roads_on_the_same_ground_become_one_for_both_directions_again(read: Read) -> None:
    """`emit opendrive` writes a single lane for both directions as two roads."""
    scene = testing.sample('''image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { lanes: 1 }''')[0].record
    network = read(OpenDriveBackend().files(scene)["xodr"])
    assert len(network.edges) == sum(road.derived for road in scene.roads) == 4
    assert {lane.direction for edge in network.edges for lane in lanes_of(edge).lanes} == {"both"}
    (junction,) = network.junctions or ()
    assert len(junction.turns) == len(scene.networks[0].junctions[0].connections)
    assert len(junction.arms) == 4


@pytest.mark.parametrize("rule", ["signals", "stop", "yield", "all_way_stop"])
@pytest.mark.parametrize("lanes", [1, 2])
def test_lights_and_signs_say_who_goes_first(tmp_path: Path, rule: str, lanes: int) -> None:
    """Those that `emit opendrive` writes are read again."""
    scene = testing.sample(f'''image plan from """
...#...
#######
...#...
""" {{ scale: 30m/px }}
network town from plan {{ lanes: {lanes}, control with {rule} }}''')[0].record
    found = sampled(tmp_path, OpenDriveBackend().files(scene)["xodr"])
    (before,), (after,) = scene.networks[0].junctions, found.networks[0].junctions
    assert after.control.kind == rule
    assert len(after.control.phases) == len(before.control.phases)
    assert len(after.control.minor) == len(before.control.minor)
    other = sampled(
        tmp_path, OpenDriveBackend().files(scene)["xodr"], "{ control with right_first }"
    )
    assert other.networks[0].junctions[0].control.kind == "right_first"
