"""`read with opendrive`: reference lines, lanes, heights and origins."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from roadlang.geometry import RoadNetwork
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_formats.read_opendrive import OpenDriveMap
from tests.formats.opendrive_reader import ReadFile, pose_of
from tests.formats.read_maps import found_in, lanes_of, sampled
from tests.formats.small_maps import (
    TWO_WAY,
    lane,
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
def read(tmp_path: Path) -> Read:
    return lambda text: found_in(tmp_path, text).network


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


@pytest.mark.parametrize(
    ("access", "kind"),
    [
        ('<access sOffset="0" rule="allow" restriction="bus"/>', "bus"),
        (
            '<access sOffset="0" rule="allow"><restriction type="bus"/><restriction type="taxi"/>'
            "</access>",
            "bus",
        ),
        ('<access sOffset="0" rule="deny" restriction="bus"/>', "drive"),
        ('<access sOffset="0" rule="allow"><restriction type="truck"/></access>', "drive"),
    ],
)
def test_a_lane_that_only_buses_and_taxis_may_use_is_a_bus_lane(
    read: Read, access: str, kind: str
) -> None:
    lanes = section(0, [lane(1)], [lane(-1).replace("</lane>", f"{access}</lane>")])
    (edge,) = read(xodr(straight(1, 0, 0, lanes=lanes))).edges
    assert [lane.kind for lane in lanes_of(edge).lanes] == ["drive", kind]


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


@pytest.mark.parametrize(("end", "width"), [(20.7, 2.0), (20.205, 0.0)])
def test_short_lanes_keep_their_width_and_the_shortest_are_no_fault(
    tmp_path: Path, end: float, width: float
) -> None:
    short = section(20.2, [lane(1)], [lane(-1), lane(-2, 2.0, "shoulder")])
    lanes = TWO_WAY + short + section(end, [lane(1)], [lane(-1)])
    scene = sampled(tmp_path, xodr(straight(1, 0, 0, lanes=lanes)))
    widths = {found.id: np.max(found.width) for found in scene.roads[0].lane_list}
    assert widths == pytest.approx({1: 3.5, -1: 3.5, -2: width}, abs=1e-5)


@pytest.mark.parametrize(
    ("latitude", "longitude", "is_kept"),
    [(89, -179, True), (-90, 180, True), (91, 0, False), (0, 181, False), (0, -200, False)],
)
def test_origins_that_are_not_on_earth_are_left_out(
    read: Read, latitude: int, longitude: int, is_kept: bool
) -> None:
    header = f"<geoReference>+proj=tmerc +lat_0={latitude} +lon_0={longitude}</geoReference>"
    expected = (latitude, longitude) if is_kept else None
    assert read(xodr(straight(1, 0, 0), header=header)).origin == expected


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
