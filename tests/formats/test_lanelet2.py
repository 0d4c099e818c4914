"""`emit lanelet2`: lanelets that share their points, and what holds on them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree.ElementTree import Element, fromstring

import numpy as np
import pytest

from roadlang import testing
from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang_formats.emit_lanelet2 import Lanelet2Backend
from roadlang_formats.lanelet2.document import TOLERANCE
from roadlang_formats.lanelet2.primitives import Primitives
from roadlang_formats.lanelet2.regulatory_elements import RegulatoryElements
from roadlang_formats.lanelets.network import lanelet_map
from tests.formats.test_commonroad import CROSSING, STREET, scene_of


@dataclass(frozen=True)
class ReadMap:
    """The elements of a file."""

    root: Element

    @classmethod
    def of(cls, text: str, **options: object) -> ReadMap:
        return cls(fromstring(Lanelet2Backend(**options).files(scene_of(text))["lanelet2.osm"]))  # type: ignore[arg-type]

    def tagged(self, tag: str, **tags: str) -> list[Element]:
        return [item for item in self.root.iterfind(tag) if tags.items() <= tags_of(item).items()]

    def nodes(self, lanelet: Element, role: str) -> list[str]:
        (ref,) = members(lanelet, role)
        (way,) = (way for way in self.root.iterfind("way") if way.attrib["id"] == ref)
        return [nd.attrib["ref"] for nd in way.iterfind("nd")]


def tags_of(element: Element) -> dict[str, str]:
    return {tag.attrib["k"]: tag.attrib["v"] for tag in element.iterfind("tag")}


def members(element: Element, role: str) -> list[str]:
    return [m.attrib["ref"] for m in element.iterfind("member") if m.attrib["role"] == role]


def test_lanes_beside_each_other_share_a_line() -> None:
    found = ReadMap.of(STREET)
    left, right = found.tagged("relation", type="lanelet", road="street")
    assert members(left, "left") == members(right, "left")
    ways = {way.attrib["id"]: tags_of(way) for way in found.root.iterfind("way")}
    assert ways[members(left, "left")[0]] == {"type": "line_thin", "subtype": "dashed"}
    assert ways[members(left, "right")[0]] == {"type": "line_thin", "subtype": "solid"}
    assert tags_of(left)["speed_limit"] == "54 km/h"
    (limit,) = found.tagged("relation", subtype="speed_limit")
    assert members(left, "regulatory_element") == [limit.attrib["id"]]


@pytest.mark.parametrize("lanes", [1, 2, 4])
def test_turns_share_their_end_points_with_the_lanes_that_they_connect(lanes: int) -> None:
    scene = scene_of(CROSSING % f"lanes: {lanes}")
    found = ReadMap.of(CROSSING % f"lanes: {lanes}")
    lanelets = found.tagged("relation", type="lanelet")
    turns = [lanelet for lanelet in lanelets if "turn_direction" in tags_of(lanelet)]
    roads = [lanelet for lanelet in lanelets if lanelet not in turns]
    assert len(turns) == len(scene.networks[0].junctions[0].connections)
    ends = {end for lanelet in roads for end in _ends(found, lanelet)}
    for turn in turns:
        assert ends.issuperset(_ends(found, turn))


def _ends(found: ReadMap, lanelet: Element) -> Iterator[frozenset[str]]:
    left, right = found.nodes(lanelet, "left"), found.nodes(lanelet, "right")
    # A border may run either way; both ends of a lanelet are still pairs of points.
    if "turn_direction" in tags_of(lanelet) or left[0] != right[0]:
        yield frozenset((left[0], right[0]))
        yield frozenset((left[-1], right[-1]))


@pytest.mark.parametrize(
    ("rule", "subtype", "role"),
    [
        ("control with signals", "traffic_light", "refers"),
        ("control with stop", "right_of_way", "right_of_way"),
        ("control with all_way_stop", "all_way_stop", "yield"),
    ],
)
def test_junctions_have_the_rules_of_the_scene(rule: str, subtype: str, role: str) -> None:
    found = ReadMap.of(CROSSING % f"lanes: 2, {rule}")
    rules = found.tagged("relation", type="regulatory_element", subtype=subtype)
    assert rules
    for element in rules:
        assert members(element, role)
        assert members(element, "ref_line")
        holders = [
            lanelet
            for lanelet in found.tagged("relation", type="lanelet")
            if element.attrib["id"] in members(lanelet, "regulatory_element")
        ]
        assert all("turn_direction" in tags_of(lanelet) for lanelet in holders)
        assert holders


def test_borders_of_connections_are_whole_micrometers_between_their_lanes() -> None:
    lanelets = lanelet_map(scene_of(CROSSING % "lanes: 2"), TOLERANCE)
    numbers = [number for one in lanelets.junctions for number in one.connections.values()]
    sides = [
        side for n in numbers for side in (lanelets.lanelets[n].left, lanelets.lanelets[n].right)
    ]
    inner = [lanelets.borders[side.border].points[1:-1] for side in sides]
    assert all(inner)
    found = np.array([point[:2] for points in inner for point in points])
    assert (found == np.round(found, 6)).all()
    assert (found != np.round(found, 5)).any()


@pytest.mark.parametrize("left_out", ["yielding", "prior", "neither"])
def test_a_rule_names_who_yields_and_to_whom_or_is_none(left_out: str) -> None:
    lanelets = lanelet_map(scene_of(CROSSING % "lanes: 2, control with stop"), TOLERANCE)
    junction = max(lanelets.junctions, key=lambda found: len(found.junction.yields))
    low = junction.junction.yields[0][0]
    highs = {high for one, high in junction.junction.yields if one == low}
    without = {"yielding": {low}, "prior": highs, "neither": set()}[left_out]
    numbers = {junction.connections[id] for id in {low, *highs} - without}
    ids = {number: id for id, number in enumerate(sorted(numbers), 1)}
    primitives = Primitives(LocalProjection(0.0, 0.0), reserved=len(ids))
    rules = RegulatoryElements(primitives, lanelets, ids)
    rules.add_junction(junction)
    found = [number for number in ids if rules.of(number)]
    assert (junction.connections[low] in found) is (left_out == "neither")


def test_points_are_where_the_origin_says() -> None:
    found = ReadMap.of(STREET, origin=(0.84, 0.2))
    projection = LocalProjection(math.degrees(0.84), math.degrees(0.2))
    for node in found.root.iterfind("node"):
        place = float(node.attrib["lat"]), float(node.attrib["lon"])
        tags = tags_of(node)
        assert projection.point(*place) == pytest.approx(
            (float(tags["local_x"]), float(tags["local_y"])), abs=1e-3
        )


def test_sidewalks_are_walkways_and_nobody_is_on_medians() -> None:
    found = ReadMap.of(
        "road main { draw with waypoints { points: [(0m, 0m), (90m, 20m)] }, "
        "left: [median(2m), drive, sidewalk(2m)], right: [drive, bike(1.5m), sidewalk(2m)] }"
    )
    subtypes = [tags_of(item)["subtype"] for item in found.tagged("relation", type="lanelet")]
    assert sorted(subtypes) == ["bicycle_lane", "road", "road", "walkway", "walkway"]


def test_the_same_scene_gives_the_same_bytes() -> None:
    scene = testing.sample(CROSSING % "lanes: 2, control with signals")[0].record
    first, second = (Lanelet2Backend().files(scene) for _ in range(2))
    assert first == second


def test_a_light_lies_across_the_lane_that_it_is_for() -> None:
    """A line of some width, whose middle is on the stop line's side of the road."""
    found = ReadMap.of(CROSSING % "lanes: 2, control with signals")
    places = {
        node.attrib["id"]: (float(tags_of(node)["local_x"]), float(tags_of(node)["local_y"]))
        for node in found.root.iterfind("node")
    }
    ways = {
        way.attrib["id"]: [places[nd.attrib["ref"]] for nd in way.iterfind("nd")]
        for way in found.root.iterfind("way")
    }
    rules = found.tagged("relation", subtype="traffic_light")
    assert rules
    for rule in rules:
        (light,) = (ways[id] for id in members(rule, "refers"))
        (line,) = (ways[id] for id in members(rule, "ref_line"))
        assert math.dist(*light) > 0.2
        along, across = (complex(*b) - complex(*a) for a, *_, b in (light, line))
        assert abs((along / across).imag) < 0.01 * abs(along / across)
