"""`turn:lanes` of OpenStreetMap: which lanes lead where."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang import testing
from roadlang_formats.osm_reading.lane_arrows import written_arrows
from tests.formats.test_read_osm import osm, read, way


def led(folder: Path, *ways: str, left: bool = False) -> dict[tuple[str, int], set[str]]:
    """Where each lane of a street leads, by the names of streets; one-way streets run outward."""
    side = "left" if left else "right"
    read(folder, osm(*ways))
    text = f'network town from "{folder / "town.osm"}" {{ read with osm {{ traffic: {side} }} }}\n'
    scene = testing.sample(text + f"world {{ traffic: {side} }}")[0].record
    names = {road.name: road.street or road.name for road in scene.roads}
    found: dict[tuple[str, int], set[str]] = {}
    for network in scene.networks:
        for junction in network.junctions:
            for turn in junction.connections:
                key = names[turn.source.road], turn.source.lane
                found.setdefault(key, set()).add(names[turn.target.road])
    return found


def crossing(west: str, **tags: str) -> list[str]:
    """A street from the west to a crossing whose other streets lead away from it."""
    out = {"oneway": "yes", "lanes": "2"}
    return [
        way(1, "31 32 33", name="west", **{west: tags.pop("turn")}, **tags),
        way(2, "33 43 53", name="north", **out),
        way(3, "33 34 35", name="east", **out),
        way(4, "33 23 13", name="south", **out),
    ]


@pytest.mark.parametrize(
    ("tags", "written"),
    [
        ({"turn:lanes": "left|right"}, ("", "")),
        ({"turn:lanes": "left|right", "oneway": "yes"}, ("", "left|right")),
        ({"turn:lanes": "left|right", "oneway": "-1"}, ("left|right", "")),
        ({"turn:lanes:forward": "left", "turn:lanes:backward": "right"}, ("right", "left")),
        ({"turn:lanes": "through", "turn:lanes:forward": "left", "oneway": "yes"}, ("", "left")),
    ],
)
def test_the_direction_of_a_way_says_for_whom_arrows_are(
    tags: dict[str, str], written: tuple[str, str]
) -> None:
    assert written_arrows(tags) == written


def test_lanes_lead_where_their_arrows_point(tmp_path: Path) -> None:
    one_way = {"oneway": "yes", "lanes": "3"}
    found = led(tmp_path, *crossing("turn_lanes", turn="left|left;through|right", **one_way))
    assert found == {
        ("west", -1): {"north"},
        ("west", -2): {"north", "east"},
        ("west", -3): {"south"},
    }


def test_lanes_without_arrows_have_the_share_that_they_would_have(tmp_path: Path) -> None:
    one_way = {"oneway": "yes", "lanes": "3"}
    plain = led(tmp_path, *crossing("note", turn="none", **one_way))
    assert plain == {("west", -1): {"north"}, ("west", -2): {"east"}, ("west", -3): {"south"}}
    for tag in ("|through|", "none|through|none", "left||right"):
        assert led(tmp_path, *crossing("turn_lanes", turn=tag, **one_way)) == plain
    wrong = led(tmp_path, *crossing("turn_lanes", turn="right|left", **one_way))
    assert wrong == plain  # for as many lanes as there are not


@pytest.mark.parametrize("tag", ["turn_lanes_forward", "turn_lanes_backward"])
def test_both_directions_have_arrows_of_their_own(tmp_path: Path, tag: str) -> None:
    """The way may be drawn toward the crossing or away from it."""
    lanes = {"lanes": "4", "lanes_forward": "2", "lanes_backward": "2"}
    ways = crossing(tag, turn="left|through;right", **lanes)
    if tag.endswith("backward"):
        ways[0] = ways[0].replace(
            '<nd ref="31"/><nd ref="32"/><nd ref="33"/>',
            '<nd ref="33"/><nd ref="32"/><nd ref="31"/>',
        )
    found = led(tmp_path, *ways)
    assert sorted(map(sorted, found.values())) == [["east", "south"], ["north"]]
    assert sorted(abs(lane) for _, lane in found) == [1, 2]


def test_on_the_left_lanes_are_counted_from_the_left_too(tmp_path: Path) -> None:
    one_way = {"oneway": "yes", "lanes": "3"}
    ways = crossing("turn_lanes", turn="left|through|through;right", **one_way)
    found = led(tmp_path, *ways, left=True)
    assert sorted(map(sorted, found.values())) == [["east"], ["east", "south"], ["north"]]
    assert found["west", 3] == {"north"}


def test_arrows_are_for_the_end_of_the_whole_way(tmp_path: Path) -> None:
    """At 32 a street leads off to the north, which no arrow of the way means."""
    one_way = {"oneway": "yes", "lanes": "2"}
    ways = crossing("turn_lanes", turn="through|right", **one_way)
    side = way(5, "32 42", name="side", oneway="yes")
    found = led(tmp_path, *ways, side)
    assert "side" in found["west", -1]
    assert found["west", -2] == {"south", "west"}
