"""What is drawn of roads and junctions, by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.ir.scene import SceneNetwork, SceneRoad
from roadlang.ir.scene_junctions import SceneArm, SceneJunction
from roadlang.ir.scene_lane import SceneLane
from roadlang.ir.scene_surface import SurfacePatch
from roadlang.report.outlines import Outline, outline, outlines, surfaces
from roadlang.scenes.figure_colors import FIGURE_COLORS
from tests.backends.handmade_scenes import actor, bend, road, through


def straight(**changes: Any) -> SceneRoad:
    """100 m along the x axis, two lanes of 3.5 m."""
    points = [(float(x), 0.0) for x in range(0, 101, 10)]
    return through("main", points, width=(7.0,) * len(points), **changes)


def test_a_straight_road_is_a_rectangle_with_a_broken_line() -> None:
    found = outline(straight())
    assert found.surface.tolist() == [[0.0, 3.5], [100.0, 3.5], [100.0, -3.5], [0.0, -3.5]]
    ((line, broken),) = found.lines
    assert line.tolist() == [[0.0, 0.0], [100.0, 0.0]]
    assert broken


def test_lanes_of_another_surface_have_its_color_where_it_lies() -> None:
    patch = SurfacePatch("ice", 23.0, 41.5, (-1,))
    ((ring, color),) = outline(straight(surface_patches=(patch,))).covers
    assert color == FIGURE_COLORS.of_surface("ice")
    assert ring.tolist() == [[23.0, 0.0], [41.5, 0.0], [41.5, -3.5], [23.0, -3.5]]
    assert len(outline(straight(surface="gravel")).covers) == 2
    assert outline(straight(surface="asphalt")).covers == ()


@pytest.mark.parametrize(
    ("marking", "broken"),
    [("broken", [True]), ("solid", [False]), ("double", [False, False]), ("none", [])],
)
def test_lines_are_broken_whole_or_not_there(marking: str, broken: list[bool]) -> None:
    lanes = (
        SceneLane(1, "drive", "backward", (3.5,)),
        SceneLane(-1, "drive", "forward", (3.5,)),
    )
    main = straight(lane_list=lanes, center_marking=marking)
    assert [is_broken for _, is_broken in outline(main).lines] == broken


def test_lines_end_where_junctions_begin_and_the_surface_does_not() -> None:
    found = outline(straight(trim=(20.0, 30.0)))
    ((line, _),) = found.lines
    assert line.tolist() == [[20.0, 0.0], [70.0, 0.0]]
    assert found.surface[:, 0].max() == 100.0
    assert outline(straight(trim=(20.0, 80.0))).lines == ()


def test_a_closed_road_has_a_hole_and_its_line_comes_round() -> None:
    around = np.linspace(0.0, 2.0 * np.pi, 361)[:-1]
    ring = through("ring", [(50.0 * np.cos(a), 50.0 * np.sin(a)) for a in around])
    ring = replace(
        ring, closed=True, heading=tuple(around + np.pi / 2.0), length=100.0 * np.pi,
        width=(6.0,) * 360,
    )  # fmt: skip
    found = outline(ring)
    radii = np.hypot(*found.surface.T)
    half = len(radii) // 2
    np.testing.assert_allclose(radii[:half], 47.0, atol=0.01)
    np.testing.assert_allclose(radii[-half:], 53.0, atol=0.01)
    assert found.surface[0].tolist() == pytest.approx([47.0, 0.0])
    assert found.surface[-1].tolist() == pytest.approx([53.0, 0.0])
    ((line, _),) = found.lines
    assert line[0].tolist() == line[-1].tolist() == pytest.approx([50.0, 0.0])


def test_only_derived_roads_are_drawn_where_there_are_some_and_junctions_of_their_network() -> None:
    area = ((0.0, 0.0), (9.0, 0.0), (9.0, 9.0))
    place = SceneJunction(0, (0,), "junction", area, (SceneArm("main", "end", 0.0, 2, 0),), ())
    line = replace(place, id=1, area=area[:2])
    town = SceneNetwork("town", (), ("main",), junctions=(place, line))
    main, bent = straight(network="town"), replace(straight(derived=True), name="bent")
    scene = replace(bend(), roads=(main,), networks=(town,))
    roads = outlines(scene)
    assert len(roads) == 2, "a road, and the only junction that has an area"
    assert roads[1].surface.tolist() == [list(corner) for corner in area]
    assert len(outlines(replace(scene, roads=(main, bent)))) == 1, "no road of the network"
    both = replace(scene, roads=(main, bent, replace(main, derived=True)))
    assert len(outlines(both)) == 3


def test_the_page_gets_steps_of_centimeters() -> None:
    ring = np.array([[0.0, 0.0], [1.234, 0.0], [1.234, -2.0]])
    lines = ((ring[:2], True), (ring[1:], False))
    record = Outline(ring, lines, ((ring, True),), (ring[:2],), ((ring, "red"),)).record()
    assert record == {
        "surface": [[0, 123, 0], [0, 0, -200]],
        "lines": [[[[0, 123], [0, 0]], 1], [[[123, 0], [0, -200]], 0]],
        "bands": [[[[0, 123, 0], [0, 0, -200]], 1]],
        "paint": [[[0, 123], [0, 0]]],
        "covers": [[[[0, 123, 0], [0, 0, -200]], "red"]],
    }


def test_a_bend_keeps_its_shape() -> None:
    found = outline(road("main", lambda x: 0.002 * x * x, 100.0))
    assert len(found.surface) > 8
    assert found.surface[0].tolist() == pytest.approx([0.0, 3.5], abs=0.01)


def test_sidewalks_and_what_is_beside_the_roadway_are_drawn_between_junctions() -> None:
    lanes = (
        SceneLane(1, "drive", "backward", (3.5,)),
        SceneLane(-1, "drive", "forward", (3.5,)),
        SceneLane(-2, "parking", "forward", (2.0,), drivable=False),
        SceneLane(-3, "sidewalk", "none", (1.0,), drivable=False, raised=True),
    )
    found = outline(straight(lane_list=lanes, trim=(20.0, 30.0)))
    boxes = [(ring.min(axis=0).tolist(), ring.max(axis=0).tolist(), up) for ring, up in found.bands]
    assert boxes == [
        ([20.0, -5.5], [70.0, -3.5], False),
        ([20.0, -6.5], [70.0, -5.5], True),
    ]
    assert found.surface.min(axis=0).tolist() == [0.0, -6.5]
    assert outline(straight()).bands == ()


def test_a_crosswalk_is_painted_on_the_road_that_it_crosses() -> None:
    zebra = replace(actor("zebra", "crosswalk", 40, 0, length=4.0, width=7.0), road="main")
    scene = replace(bend(), roads=(straight(),), markings=(zebra, replace(zebra, road="other")))
    (main,) = outlines(scene)
    stripes = np.concatenate(main.paint)
    assert stripes.min(axis=0) == pytest.approx([38.0, -3.5], abs=0.3)
    assert stripes.max(axis=0) == pytest.approx([42.0, 3.5], abs=0.3)
    record = main.record()["paint"]
    assert len(record) == len(main.paint)


def test_pictures_have_the_same_surfaces() -> None:
    area = ((0.0, 0.0), (9.0, 0.0), (9.0, 9.0))
    place = SceneJunction(0, (0,), "junction", area, (), ())
    town = SceneNetwork("town", (), ("main",), junctions=(place,))
    scene = replace(bend(), roads=(straight(network="town"),), networks=(town,))
    for plain, full in zip(surfaces(scene), outlines(scene), strict=True):
        assert plain.tolist() == full.surface.tolist()
