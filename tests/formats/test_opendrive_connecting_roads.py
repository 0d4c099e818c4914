"""The roads through junctions in OpenDRIVE: lines and arcs, those that go on in the same way as
one."""

from __future__ import annotations

import math
from xml.etree.ElementTree import Element, fromstring

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import SceneConnection
from roadlang.geometry import poses_along
from roadlang.ir.scene_junctions import SceneLaneEnd
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_formats.opendrive.connecting_roads import pieces_of

START = (2.0, -1.0, 0.3)
END = SceneLaneEnd("main", "end", -1)


def connection(*pieces: tuple[float, float]) -> SceneConnection:
    length = sum(length for length, _ in pieces)
    return SceneConnection(
        0, END, END, "left", START, pieces, length, (3.0, 3.0), ((0.0, 0.0), (0.0, 0.0))
    )


@pytest.mark.parametrize(
    ("pieces", "written"),
    [
        ([(5, 0)], [(5, "line")]),
        ([(5, 0), (3, 0)], [(8, "line")]),
        ([(5, 0), (3, 0.1), (2, 0.1), (4, -0.1)], [(5, "line"), (5, 0.1), (4, -0.1)]),
        ([(5, 1e-10), (3, -1e-10), (2, 0)], [(10, "line")]),
        ([(5, 0), (1e-9, 0.2), (4, 0)], [(9, "line")]),
        ([(5, 0.1), (1e-9, 0), (4, 0.2)], [(5, 0.1), (4, 0.2)]),
        ([(5, 0), (6, 1e-7)], [(5, "line"), (6, "paramPoly3")]),
    ],
)
def test_pieces_that_go_on_in_the_same_way_are_one(
    pieces: list[tuple[float, float]], written: list[tuple[float, object]]
) -> None:
    found = pieces_of(connection(*pieces))
    assert [piece.length for piece in found] == pytest.approx([length for length, _ in written])
    kinds = [piece.numbers[0] if piece.shape == "arc" else piece.shape for piece in found]
    assert kinds == [kind for _, kind in written]


def test_each_piece_begins_where_the_one_before_ends() -> None:
    pieces = [(5.0, 0.0), (4.0, 0.12), (3.0, -0.2), (6.0, 0.0)]
    found = pieces_of(connection(*pieces))
    assert [piece.s for piece in found] == pytest.approx([0.0, 5.0, 9.0, 12.0])
    assert (found[0].x, found[0].y, found[0].heading) == START
    assert found[1].x == pytest.approx(2.0 + 5.0 * math.cos(0.3))
    assert [piece.heading for piece in found] == pytest.approx([0.3, 0.3, 0.78, 0.18])
    for (length, curvature), one, other in zip(pieces, found, found[1:], strict=False):
        pose = np.array([one.x, one.y, one.heading])
        after = poses_along(pose, (curvature, curvature), np.array([0.0, length]))[-1]
        assert (other.x, other.y, other.heading) == pytest.approx(tuple(after))


def test_a_lane_with_its_own_limit_has_it_on_the_roads_that_lead_to_it() -> None:
    """As the engine has it: the limit of a lane counts before that of its road."""
    (scene,) = testing.sample(
        'image plan from """\n...#...\n#######\n...#...\n""" { scale: 30m/px }\n'
        "network town from plan { right: [drive(3.5m, speed_limit: 10m/s)], left: [drive(3.5m)],"
        " speed_limit: 15m/s }\n"
    )
    document = fromstring(OpenDriveBackend().files(scene.record)["xodr"])
    through = [road for road in document.iterfind("road") if road.attrib["junction"] != "-1"]
    limits = {
        (road.find("type/speed").attrib["max"], _lane_after(road))  # type: ignore[union-attr]
        for road in through
    }
    assert limits == {("10", "-1"), ("15", "1")}


def _lane_after(road: Element) -> str:
    return next(link.attrib["id"] for link in road.iterfind(".//lane/link/successor"))
