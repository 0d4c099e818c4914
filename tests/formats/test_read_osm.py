"""`read with osm`: streets of small extracts."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import roadlang
from roadlang import testing
from roadlang.api import Extraction
from roadlang.geometry import CrossSection, Edge
from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang_formats.osm_reading.way_lanes import WayLanes, speed_limit, way_lanes
from roadlang_formats.read_osm import OpenStreetMap

LATITUDE, LONGITUDE = 48.0, 11.0
STEP = 0.001
"""Degrees between nodes: 111 m north, 74 m east."""


def osm(*ways: str, nodes: str = "") -> str:
    """A grid of nodes called `11` to `55`, by row from the south and column from the west."""
    grid = "".join(
        f'<node id="{row}{column}" lat="{LATITUDE + STEP * row}" '
        f'lon="{LONGITUDE + STEP * column}"/>\n'
        for row in range(1, 6)
        for column in range(1, 6)
    )
    return f'<osm version="0.6">\n{grid}{nodes}{"".join(ways)}</osm>\n'


def way(id: int, nodes: str, **tags: str) -> str:
    """A street, unless `highway` says otherwise; `_` in the name of a tag is a colon."""
    named = {"highway": "residential", **tags}
    refs = "".join(f'<nd ref="{node}"/>' for node in nodes.split())
    listed = "".join(
        f'<tag k="{key.replace("_", ":")}" v="{value}"/>' for key, value in named.items()
    )
    return f'<way id="{id}">{refs}{listed}</way>\n'


def read(tmp_path: Path, text: str, **options: object) -> Extraction:
    path = tmp_path / "town.osm"
    path.write_text(text)
    found: Extraction = OpenStreetMap(**options).read(path)  # type: ignore[arg-type]
    return found


def lanes_of(edge: Edge) -> CrossSection:
    assert edge.cross_section is not None
    return edge.cross_section


def test_ways_are_cut_where_they_meet(tmp_path: Path) -> None:
    network = read(tmp_path, osm(way(1, "31 33 35"), way(2, "13 33 53"))).network
    assert sorted(network.degree(node.id) for node in network.nodes) == [1, 1, 1, 1, 4]
    assert len(network.edges) == 4


def test_parts_of_one_street_are_one_road(tmp_path: Path) -> None:
    text = osm(way(1, "31 32", name="Main"), way(2, "34 33 32", name="Main"), way(3, "34 35"))
    network = read(tmp_path, text).network
    assert [edge.name for edge in network.edges] == ["Main", ""]


@pytest.mark.parametrize("first", ["31 32 33", "33 32 31"])
@pytest.mark.parametrize("second", ["33 34 35", "35 34 33"])
def test_ways_of_a_street_are_joined_however_each_was_drawn(
    tmp_path: Path, first: str, second: str
) -> None:
    text = osm(way(1, first, name="Main"), way(2, second, name="Main"))
    (edge,) = read(tmp_path, text).network.edges
    steps = np.diff(edge.curve.points[:, 0])
    assert edge.curve.length == pytest.approx(4 * 74.4, rel=0.01)
    assert (steps > 0.0).all() or (steps < 0.0).all()


def test_a_one_way_street_goes_on_only_in_its_direction(tmp_path: Path) -> None:
    against = osm(way(1, "31 32", oneway="yes"), way(2, "33 32", oneway="yes"))
    along = osm(way(1, "31 32", oneway="yes"), way(2, "32 33", oneway="yes"))
    assert len(read(tmp_path, against).network.edges) == 2
    assert len(read(tmp_path, along).network.edges) == 1


def test_what_no_vehicle_drives_on_is_left_out(tmp_path: Path) -> None:
    text = osm(
        way(1, "31 33"),
        way(2, "13 33", highway="footway"),
        way(3, "53 33", highway="service"),
        way(4, "11 12", highway="residential", area="yes"),
    )
    assert len(read(tmp_path, text).network.edges) == 2
    assert len(read(tmp_path, text, service=False).network.edges) == 1


@pytest.mark.parametrize(
    ("tags", "forward", "backward"),
    [
        ({"highway": "residential"}, 1, 1),
        ({"highway": "primary"}, 2, 2),
        ({"highway": "motorway"}, 2, 0),
        ({"highway": "residential", "lanes": "3"}, 2, 1),
        ({"highway": "residential", "lanes": "1"}, 1, 1),
        ({"highway": "residential", "lanes": "3", "lanes:backward": "2"}, 1, 2),
        ({"highway": "secondary", "lanes": "5", "lanes:forward": "2"}, 2, 3),
        ({"highway": "residential", "oneway": "yes", "lanes": "2"}, 2, 0),
        ({"highway": "residential", "oneway": "-1"}, 0, 1),
        ({"highway": "tertiary", "junction": "roundabout"}, 1, 0),
        ({"highway": "residential", "lanes": "many"}, 1, 1),
    ],
)
def test_lanes_are_counted_by_the_tags(tags: dict[str, str], forward: int, backward: int) -> None:
    assert way_lanes(tags) == WayLanes(forward, backward, None, None)


@pytest.mark.parametrize(
    ("written", "limit"),
    [("50", 50 / 3.6), ("30 mph", 30 * 0.44704), ("none", None), ("0", None)],
)
def test_speed_limits_are_kilometers_per_hour_or_miles(written: str, limit: float | None) -> None:
    found = speed_limit(written)
    assert found == (None if limit is None else pytest.approx(limit))


def test_lanes_run_as_the_way_does(tmp_path: Path) -> None:
    text = osm(way(1, "31 33", oneway="-1", lanes="2", maxspeed="36"))
    (edge,) = read(tmp_path, text, lane_width=3.0).network.edges
    assert [(lane.id, lane.direction, lane.speed_limit) for lane in lanes_of(edge).lanes] == [
        (-1, "backward", 10.0),
        (-2, "backward", 10.0),
    ]
    assert lanes_of(edge).border_offsets(5.0) == pytest.approx([3.0, 0.0, -3.0])


def test_ways_that_run_toward_each_other_keep_the_limit_of_each_direction(tmp_path: Path) -> None:
    limits = {"maxspeed_forward": "36", "maxspeed_backward": "72"}
    text = osm(way(1, "31 32", **limits), way(2, "33 32", **limits))
    edges = read(tmp_path, text).network.edges
    found = [
        [(lane.direction, lane.speed_limit) for lane in lanes_of(edge).lanes] for edge in edges
    ]
    assert found == [[("backward", 20.0), ("forward", 10.0)]] * 2


def test_traffic_may_keep_left(tmp_path: Path) -> None:
    (edge,) = read(tmp_path, osm(way(1, "31 33")), traffic="left").network.edges
    assert [lane.direction for lane in lanes_of(edge).lanes] == ["forward", "backward"]


def test_the_origin_is_stated_or_the_middle(tmp_path: Path) -> None:
    text = osm(way(1, "31 33"))
    stated = (math.radians(LATITUDE + 3 * STEP), math.radians(LONGITUDE + STEP))
    network = read(tmp_path, text, origin=stated).network
    assert network.nodes[0].position == pytest.approx((0.0, 0.0), abs=1e-6)
    assert read(tmp_path, text).network.origin == pytest.approx((48.003, 11.002))


def test_the_projection_is_true_to_meters() -> None:
    """Along the equator a degree is 111,319.5 m; at 45 degrees north a minute of latitude is
    1852.2 m and one of longitude 1314.1 m (WGS84)."""
    assert LocalProjection(0.0, 7.0).point(0.0, 7.1)[0] == pytest.approx(11131.95, rel=1e-5)
    x, y = LocalProjection(45.0, 7.0).point(45.0 + 1 / 60, 7.0)
    assert (x, y) == pytest.approx((0.0, 1852.25), abs=0.1)
    assert LocalProjection(45.0, 7.0).point(45.0, 7.0 + 1 / 60)[0] == pytest.approx(1314.2, abs=0.1)


def test_corners_are_rounded_and_ends_stay(tmp_path: Path) -> None:
    (edge,) = read(tmp_path, osm(way(1, "31 33 53"))).network.edges
    assert np.abs(edge.curve.curvature(edge.curve.stations(spacing=1.0))).max() < 1 / 14.9
    assert edge.curve.project([[0.0, 0.0]])[0] > 0.0


def test_buildings_are_rectangles(tmp_path: Path) -> None:
    text = osm(way(1, "31 33"), way(2, "11 12 22 21 11", building="yes", highway="no"))
    assert read(tmp_path, text).objects == ()
    (found,) = read(tmp_path, text, buildings=True).objects
    assert sorted((found.length, found.width)) == pytest.approx([74.6, 111.2], abs=0.3)


def test_a_ring_is_two_roads(tmp_path: Path) -> None:
    text = osm(way(1, "22 24 44 42 22", junction="roundabout"))
    network = read(tmp_path, text).network
    assert len(network.edges) == 2
    assert {network.degree(node.id) for node in network.nodes} == {2}


def test_a_town_compiles_with_its_junctions(tmp_path: Path) -> None:
    path = tmp_path / "town.osm"
    path.write_text(osm(way(1, "31 33 35"), way(2, "13 33 53", oneway="yes")))
    scene = testing.sample(f'network town from "{path}"\nagent ego is car on town at random\n')[0]
    (junction,) = scene.record.networks[0].junctions
    assert len(junction.arms) == 4
    assert {connection.turn for connection in junction.connections} == {"left", "straight", "right"}


def test_what_the_user_of_an_editor_deleted_is_left_out(tmp_path: Path) -> None:
    deleted = way(2, "13 33 53").replace("<way", '<way action="delete"')
    assert len(read(tmp_path, osm(way(1, "31 33 35"), deleted, deleted)).network.edges) == 1


@pytest.mark.parametrize("deleted", ["", "33"])
def test_ways_are_cut_where_nodes_are_missing(tmp_path: Path, deleted: str) -> None:
    node = f'<node id="{deleted}"'
    missing = deleted or "absent"
    text = osm(way(1, f"31 32 {missing} gone 34 35 also 15", name="Main"))
    text = text.replace(node, f'{node} action="delete"')
    network = read(tmp_path, text).network
    assert [edge.name for edge in network.edges] == ["Main", "Main"]
    assert [edge.length for edge in network.edges] == pytest.approx([74.6, 74.6], abs=0.3)


LANELET = '<osm version="0.6"><relation id="1"><tag k="type" v="lanelet"/></relation></osm>'


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("<osm></osm>", "no way"),
        (
            osm(way(1, "31 33")).replace('lat="48.003"', 'lat="480.03"', 1),
            "is not a place on Earth",
        ),
        (osm(way(1, "31 33"), way(1, "11 12")), "two ways"),
        (osm(way(1, "31 33"), way(2, "a 12"), nodes='<node id="a" lat="60" lon="11"/>'), "km"),
        ("<gpx/>", "not `osm`"),
        (LANELET, "Lanelet2"),
    ],
)
def test_faults_are_reported_in_the_file(tmp_path: Path, text: str, word: str) -> None:
    with pytest.raises(roadlang.DiagnosticError, match=word) as caught:
        read(tmp_path, text)
    (found,) = caught.value.diagnostics
    assert found.code == "RL479"
    assert found.span is not None


@pytest.mark.parametrize(
    ("latitude", "longitude", "says"),
    [
        (89.0, 11.0, ""), (89.001, 11.0, "89.001 degrees: .* pole"), (-89.0, 180.0, ""),
        (-89.001, 180.0, "pole"), (48.0, -180.0, ""), (48.0, 180.001, "not a place on Earth"),
        (48.0, -180.001, "not a place on Earth"), (91.0, 11.0, "in the place of the latitude"),
    ],
)  # fmt: skip
def test_places_are_on_earth_but_not_at_a_pole(
    tmp_path: Path, latitude: float, longitude: float, says: str
) -> None:
    toward = 0.001 if latitude < 0.0 else -0.001
    nodes = f'<node id="a" lat="{latitude}" lon="{longitude}"/>'
    nodes += f'<node id="b" lat="{latitude + 1.5 * toward}" lon="{longitude}"/>'
    text = osm(way(1, "a b"), nodes=nodes)
    if not says:
        assert len(read(tmp_path, text).network.edges) == 1
    else:
        with pytest.raises(roadlang.DiagnosticError, match=says):
            read(tmp_path, text)


def tagged_node(id: str, east: float, north: float, **tags: str) -> str:
    """A node so many degrees from the corner of the grid."""
    listed = "".join(
        f'<tag k="{k.replace("_DIR", ":direction")}" v="{v}"/>' for k, v in tags.items()
    )
    place = f'lat="{LATITUDE + north}" lon="{LONGITUDE + east}"'
    return f'<node id="{id}" {place}>{listed}</node>\n'


@pytest.mark.parametrize(
    ("node", "kind", "minor"),
    [
        ({}, "right_first", 0),
        ({"highway": "traffic_signals"}, "signals", 0),
        ({"highway": "stop"}, "stop", 1),
        ({"highway": "give_way", "direction": "forward"}, "yield", 1),
        ({"highway": "give_way", "direction": "backward"}, "right_first", 0),
        ({"highway": "traffic_signals", "traffic_signals_DIR": "backward"}, "right_first", 0),
    ],
)
def test_signals_and_signs_before_a_junction_are_for_it(
    tmp_path: Path, node: dict[str, str], kind: str, minor: int
) -> None:
    """The node is 15 m west of the junction, on a street that runs east."""
    nodes = tagged_node("s", 3 * STEP - 0.0002, 3 * STEP, **node)
    path = tmp_path / "town.osm"
    path.write_text(osm(way(1, "31 s 33 35"), way(2, "13 33 53"), nodes=nodes))
    scene = testing.sample(f'network town from "{path}"')[0].record
    (junction,) = scene.networks[0].junctions
    assert junction.control.kind == kind
    assert len(junction.control.minor) == minor
    assert bool(junction.control.phases) == (kind == "signals")


@pytest.mark.parametrize(("tags", "kind"), [
    ({"highway": "traffic_signals"}, "signals"),
    ({"highway": "stop", "stop": "all"}, "all_way_stop"),
    ({"highway": "stop"}, "right_first"),
])  # fmt: skip
def test_signals_and_signs_at_the_node_of_a_junction(
    tmp_path: Path, tags: dict[str, str], kind: str
) -> None:
    middle = tagged_node("m", 3 * STEP, 3 * STEP, **tags)
    path = tmp_path / "town.osm"
    path.write_text(osm(way(1, "31 m 35"), way(2, "13 m 53"), nodes=middle))
    scene = testing.sample(f'network town from "{path}"')[0].record
    assert scene.networks[0].junctions[0].control.kind == kind


@pytest.mark.parametrize(
    ("forward", "backward", "marks", "middle"),
    [
        (1, 1, "solid solid", "broken"),
        (2, 2, "solid broken broken solid", "double"),
        (3, 0, "broken broken solid", "solid"),
        (2, 1, "solid broken solid", "broken"),
    ],
)
def test_the_outermost_lines_are_solid(
    forward: int, backward: int, marks: str, middle: str, tmp_path: Path
) -> None:
    """Lanes have the line on their outer side; the left edge of a one-way street is its center."""
    tags = {"lanes": f"{forward + backward}", "lanes_backward": f"{backward}"}
    tags |= {} if backward else {"oneway": "yes"}
    (edge,) = read(tmp_path, osm(way(1, "31 33", **tags))).network.edges
    section = lanes_of(edge)
    found = [lane.marking for lane in section.lanes]
    assert (" ".join(found), section.center_marking) == (marks, middle)


def restriction(rule: str, source: int, node: str, target: int) -> str:
    members = (("way", source, "from"), ("node", node, "via"), ("way", target, "to"))
    listed = "".join(f'<member type="{t}" ref="{ref}" role="{role}"/>' for t, ref, role in members)
    tags = f'<tag k="type" v="restriction"/><tag k="restriction" v="{rule}"/>'
    return f'<relation id="{source}{target}">{listed}{tags}</relation>'


@pytest.mark.parametrize(("rule", "left", "turns"), [
    ("", False, {"left", "straight", "right"}), ("no_left_turn", False, {"straight", "right"}),
    ("only_left_turn", False, {"left"}), ("no_left_turn", True, {"straight", "right"}),
])  # fmt: skip
def test_restrictions_forbid_turns(tmp_path: Path, rule: str, left: bool, turns: set[str]) -> None:
    """From the south; the way to the west runs from west to east, against the turn."""
    ways = way(1, "13 33"), way(2, "33 53"), way(3, "31 33"), way(4, "33 35", name="East")
    more = restriction(rule, 1, "33", 3) if rule else ""
    path = tmp_path / "town.osm"
    path.write_text(osm(*ways, more))
    side = "traffic: left" if left else "service: true"
    world = "world { traffic: left }" if left else ""
    scene = testing.sample(f'network town from "{path}" {{ read with osm {{ {side} }} }}\n{world}')
    (junction,) = scene[0].record.networks[0].junctions
    found: dict[str, set[str]] = {}
    for connection in junction.connections:
        found.setdefault(connection.source.road, set()).add(connection.turn)
    assert found.pop("town/1") == turns
    assert all(len(others) == 3 for others in found.values())


@pytest.mark.parametrize(("tags", "level"), [
    ({}, 0), ({"bridge": "yes"}, 1), ({"tunnel": "yes"}, -1), ({"bridge": "no"}, 0),
    ({"bridge": "viaduct", "layer": "2"}, 2), ({"layer": "up", "tunnel": "yes"}, -1),
])  # fmt: skip
def test_bridges_cross_without_touching(tmp_path: Path, tags: dict[str, str], level: int) -> None:
    """Ways that cross without a common node overlap, unless they are at different levels."""
    path = tmp_path / "town.osm"
    path.write_text(osm(way(1, "31 35"), way(2, "13 53", **tags)))
    edges = OpenStreetMap().read(path).network.edges
    assert [edge.level for edge in edges] == [0, level]
    scenes = testing.sample(f'network town from "{path}"')
    assert any(found.code == "RL436" for found in scenes.diagnostics) == (level == 0)
    assert scenes[0].record.networks[0].junctions == ()


def test_ways_that_are_no_roads_are_named_with_their_line(tmp_path: Path) -> None:
    """Way 8 goes straight back where it came from."""
    text = osm(way(1, "31 33 35"), way(8, "11 12 11"))
    found = read(tmp_path, text)
    assert len(found.network.edges) == 1
    (warning,) = found.warnings
    assert warning.span is not None
    assert text[warning.span.start :].startswith('<way id="8">')
    assert "a part of way 8 is left out: " in warning.message
    scene = testing.sample(f'network town from "{tmp_path / "town.osm"}"')
    assert [each.code for each in scene.diagnostics].count("RL481") == 1


def test_the_ends_of_a_street_of_centimeters_are_one_node(tmp_path: Path) -> None:
    """Node 99 lies 11 cm north of 33, and has the signal."""
    close = (
        f'<node id="99" lat="{LATITUDE + 3 * STEP + 1e-6}" lon="{LONGITUDE + 3 * STEP}">'
        '<tag k="highway" v="traffic_signals"/></node>\n'
    )
    ways = way(1, "31 33"), way(2, "33 35"), way(3, "33 99"), way(4, "99 53"), way(5, "13 33")
    found = read(tmp_path, osm(*ways, nodes=close))
    assert len(found.network.edges) == 4
    assert sorted(map(found.network.degree, (n.id for n in found.network.nodes))) == [1, 1, 1, 1, 4]
    assert [control.rule for control in found.network.controls] == ["signals"]
    assert not found.warnings
