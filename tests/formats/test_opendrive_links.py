"""Roads that go on in one another: linked directly in OpenDRIVE, if their lanes meet."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from roadlang.geometry import poses_along
from roadlang_formats.emit_opendrive import OpenDriveBackend
from tests.formats.opendrive_reader import ReadFile, number
from tests.formats.read_maps import sampled, turns_of
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

FIRST = straight(1, 0, 0, inside=link(successor="road 2 start"))
SECOND = straight(2, 60, 0, inside=link(predecessor="road 1 end"))
AGAINST = road(2, 60.0, piece(0, 120, 0, math.pi, 60.0), TWO_WAY,
    inside=link(successor="road 1 end"))  # fmt: skip


def emitted(folder: Path, *roads: str, scenario: str = "") -> tuple[ReadFile, str]:
    """What is written of a map, read by an independent reader, and its text."""
    text = OpenDriveBackend().files(sampled(folder, xodr(*roads), scenario))["xodr"]
    return ReadFile.of(text), text


@pytest.mark.parametrize("bent", ["", "{ perturb with sine { amplitude: 3m, wavelength: 80m } }"])
@pytest.mark.parametrize(("second", "end"), [(SECOND, "start"), (AGAINST, "end")])
def test_roads_whose_lanes_meet_have_no_junction_between_them(
    tmp_path: Path, second: str, end: str, bent: str
) -> None:
    first = straight(1, 0, 0, inside=link(successor=f"road 2 {end}"))
    found, text = emitted(tmp_path, first, second, scenario=bent)
    assert found.root.find("junction") is None
    one, other = found.roads.values()
    (after,) = one.element.iterfind("link/successor")
    assert after.attrib == {"elementType": "road", "elementId": "2", "contactPoint": end}
    (before,) = other.element.iterfind("link/*")
    assert before.tag == ("predecessor" if end == "start" else "successor")
    assert before.attrib == {"elementType": "road", "elementId": "1", "contactPoint": "end"}
    sign = 1 if end == "start" else -1
    at = 0.0 if end == "start" else other.length
    for id in (1, -1):
        (next_lane,) = one.lane(id).iterfind("link/successor")
        assert int(next_lane.attrib["id"]) == sign * id
        points = one.middle(id, one.length), other.middle(sign * id, at)
        assert points[0] == pytest.approx(points[1], abs=1e-3)
    again = sampled(tmp_path, text)
    assert len(turns_of(again)) == 2


def test_roads_whose_lanes_do_not_meet_keep_their_joint(tmp_path: Path) -> None:
    """The second road begins half a meter to the left; or has a lane into which two lead."""
    aside = straight(2, 60, 0.5, inside=link(predecessor="road 1 end"))
    assert emitted(tmp_path, FIRST, aside)[0].root.find("junction") is not None
    wide = section(
        0, [lane(1)], [lane(-1, inside=linked(None, -1)), lane(-2, inside=linked(None, -1))]
    )
    two = straight(1, 0, 0, lanes=wide, inside=link(successor="road 2 start"))
    assert emitted(tmp_path, two, SECOND)[0].root.find("junction") is not None


def test_lanes_that_begin_at_a_link_have_no_lane_before_them(tmp_path: Path) -> None:
    """As where a road becomes wider: the new lane is reached by changing to it."""
    lanes = section(0, [lane(1, inside=linked(1))], [lane(-1, inside=linked(-1)), lane(-2)])
    wider = straight(2, 60, 0, lanes=lanes, inside=link(predecessor="road 1 end"))
    found, _ = emitted(tmp_path, FIRST, wider)
    assert found.root.find("junction") is None
    links = {id: found.roads[2].lane(id).find("link/predecessor") for id in (1, -1, -2)}
    assert {id: one is not None for id, one in links.items()} == {1: True, -1: True, -2: False}


def test_an_end_that_two_roads_are_linked_to_is_at_one_junction(tmp_path: Path) -> None:
    """As where a road ends at both ends of a loop."""
    first = straight(1, 0, 0, inside=link(successor="road 2 start"))
    other = straight(3, 60, 0, inside=link(predecessor="road 1 end"))
    found, _ = emitted(tmp_path, first, SECOND, other)
    (junction,) = found.root.iterfind("junction")
    assert len(list(junction.iterfind("connection"))) == 4
    ways = found.root.iterfind("road[@junction='-1']/link/*[@elementType='road']")
    assert list(ways) == []


def test_the_pieces_of_a_map_come_out_as_they_went_in(tmp_path: Path) -> None:
    """Short ones too, and wherever one becomes another: netconvert cuts roads off at joints where
    a cubic stands in for the line before them."""
    curvatures, lengths = (0.0, -0.1, -0.12, 0.0), (0.21, 7.9591, 6.0107, 43.3)
    pose, s, pieces = np.array([5.0, 3.0, 0.4]), 0.0, ""
    for curvature, length in zip(curvatures, lengths, strict=True):
        shape = f'<arc curvature="{curvature}"/>' if curvature else "<line/>"
        x, y, heading = pose.tolist()
        pieces += piece(s, x, y, heading, length, shape)
        pose = poses_along(pose, (curvature, curvature), np.array([0.0, length]))[-1]
        s += length
    found, _ = emitted(tmp_path, road(1, s, pieces))
    written = found.roads[1].pieces()
    assert [item[0].tag for item in written] == ["line", "arc", "arc", "line"]
    assert [number(item, "length") for item in written] == pytest.approx(lengths, abs=1e-4)


def test_connecting_roads_have_the_speed_limits_of_the_lanes_that_they_lead_to(
    tmp_path: Path,
) -> None:
    limit = '<speed sOffset="0" max="8" unit="m/s"/>'
    text = crossing().replace("</lane></right>", f"{limit}</lane></right>")
    scene = sampled(tmp_path, text)
    root = ReadFile.of(OpenDriveBackend().files(scene)["xodr"]).root
    speeds = [
        speed.attrib["max"]
        for road in root.iterfind("road")
        if road.attrib["junction"] != "-1" and road.find(".//lane[@type='driving']") is not None
        for speed in road.iterfind("type/speed")
    ]
    into_limited = sum(target_lane == -1 for *_, target_lane in turns_of(scene))
    assert speeds == ["8"] * into_limited
    assert 0 < into_limited < len(turns_of(scene))
