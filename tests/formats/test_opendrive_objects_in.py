"""`read with opendrive`: objects beside roads."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from roadlang import testing
from roadlang.api import FoundObject
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_formats.read_opendrive import OpenDriveMap
from tests.formats.read_maps import found_in, sampled
from tests.formats.small_maps import piece, road, straight, xodr


def objects_in(folder: Path, *elements: str, pieces: str = "") -> tuple[FoundObject, ...]:
    """Those of one road that runs east for 60 m from (10, 20), or along `pieces`."""
    inside = f"<objects>{''.join(elements)}</objects>"
    made = road(1, 60.0, pieces, inside=inside) if pieces else straight(1, 10, 20, inside=inside)
    return found_in(folder, xodr(made)).objects


def thing(type: str, inside: str = "", **attributes: object) -> str:
    """An object 5 m to the left of the road, 30 m along it."""
    written = {"s": 30, "t": 5, "hdg": 0.5, "zOffset": 0, **attributes}
    text = " ".join(f'{key}="{value}"' for key, value in written.items())
    return f'<object type="{type}" {text}>{inside}</object>'


@pytest.mark.parametrize(("type", "name", "kind"), [
    ("tree", "", "tree"), ("vegetation", "bigHedge", "hedge"), ("pole", "", "pole"),
    ("pole", "StreetLamp", "lamp"), ("building", "", "building"), ("barrier", "", "barrier"),
    ("barrier", "guardRail", "guardrail"), ("obstacle", "", "box"), ("obstacle", "cabinet", "box"),
    ("obstacle", "trafficCone1", "cone"), ("vegetation", "street_green", "bush"),
    ("pole", "streetlight", "lamp"),
])  # fmt: skip
def test_objects_have_the_kind_place_and_size_of_the_file(
    tmp_path: Path, type: str, name: str, kind: str
) -> None:
    element = thing(type, name=name, length=3, width=2, height=4)
    assert objects_in(tmp_path, element) == (FoundObject(kind, 40.0, 25.0, 3.0, 2.0, 0.5, 4.0),)


@pytest.mark.parametrize("element", [
    thing("crosswalk"), thing("parkingSpace"), thing("-1"), thing("tree", zOffset=4),
])  # fmt: skip
def test_what_no_vehicle_can_hit_is_no_object(tmp_path: Path, element: str) -> None:
    assert objects_in(tmp_path, element) == ()


def test_a_radius_is_a_square_and_outlines_are_rectangles(tmp_path: Path) -> None:
    local = "".join(
        f'<cornerLocal u="{u}" v="{v}" z="0" height="6"/>'
        for u, v in ((0, 0), (8, 0), (8, 3), (0, 3))
    )
    at_road = "".join(
        f'<cornerRoad s="{s}" t="{t}" dz="0" height="7"/>'
        for s, t in ((5, 4), (15, 4), (15, 8), (5, 8))
    )
    found = objects_in(
        tmp_path,
        thing("pole", radius=0.25),
        thing("building", f"<outlines><outline>{local}</outline></outlines>", hdg=math.pi / 2),
        thing("building", f"<outline>{at_road}</outline>"),
    )
    assert (found[0].length, found[0].width) == (0.5, 0.5)
    assert (found[1].x, found[1].y) == pytest.approx((38.5, 29.0))
    assert (found[1].length, found[1].width, found[1].height) == pytest.approx((8.0, 3.0, 6.0))
    assert (found[2].x, found[2].y, found[2].height) == pytest.approx((20.0, 26.0, 7.0))
    assert sorted((found[2].length, found[2].width)) == pytest.approx([4.0, 10.0])


def test_objects_are_repeated_at_distances_or_follow_the_road(tmp_path: Path) -> None:
    """A guardrail beside a bend of 50 m radius is within 10 cm of it, without gaps."""
    bend = piece(0, 0, 0, 0.0, 60.0, '<arc curvature="0.02"/>')
    trees = '<repeat s="10" length="40" distance="20" tStart="5" tEnd="7" heightStart="4"/>'
    rail = '<repeat s="0" length="60" distance="0" tStart="-4" tEnd="-4" widthStart="0.3"/>'
    found = objects_in(
        tmp_path, thing("tree", trees), thing("barrier", rail, name="guard"), pieces=bend
    )
    away = [50.0 - math.hypot(each.x, each.y - 50.0) for each in found]
    assert away[:3] == pytest.approx([5.0, 6.0, 7.0], abs=0.01)
    assert [each.height for each in found[:3]] == [4.0, 4.0, 4.0]
    parts = found[3:]
    assert {each.kind for each in parts} == {"guardrail"}
    assert all(abs(each + 4.0) < 0.15 for each in away[3:])
    assert sum(each.length for each in parts) == pytest.approx(60.0 * 54 / 50, abs=0.1)


def test_objects_that_were_written_are_read_again(tmp_path: Path) -> None:
    scene = testing.sample("""
road main { draw with waypoints { points: [(0m, 0m), (120m, 40m)] } }
object trees is tree on main at random { count: 3, side: left, offset: 3m..8m }
object hall is building at (40m, 60m) { heading: 30deg, height: 9m }
""")[0].record
    again = sampled(tmp_path, OpenDriveBackend().files(scene)["xodr"])
    assert [each.kind for each in again.objects] == ["tree", "tree", "tree", "building"]
    for one, other in zip(scene.objects, again.objects, strict=True):
        assert (other.x, other.y) == pytest.approx((one.x, one.y), abs=0.01)
        assert (other.length, other.width, other.height) == pytest.approx(
            (one.length, one.width, one.height), abs=0.01
        )


def test_objects_may_be_left_out(tmp_path: Path) -> None:
    found_in(tmp_path, xodr(straight(1, 0, 0, inside=f"<objects>{thing('tree')}</objects>")))
    assert OpenDriveMap(objects=False).read(tmp_path / "town.xodr").objects == ()


@pytest.mark.parametrize("height", [4.0, 0.5, None])
def test_the_height_of_an_object_stands_in_its_options_too(
    tmp_path: Path, height: float | None
) -> None:
    size = {} if height is None else {"height": height}
    inside = f"<objects>{thing('building', '', length=3, width=2, **size)}</objects>"
    (found,) = sampled(tmp_path, xodr(straight(1, 10, 20, inside=inside))).objects
    written = testing.sample("object hall is building at (1m, 2m)")[0].record.objects[0]
    expected = written.height if height is None else height
    assert found.height == found.options["height"] == expected
    assert (found.options["length"], found.options["width"]) == (3.0, 2.0)
