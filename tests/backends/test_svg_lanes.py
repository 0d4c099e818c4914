"""Lanes in figures: a strip of color for each kind, a line for each marking."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from xml.etree import ElementTree

import pytest

from roadlang.ir.scene import Scene, SceneRoad
from roadlang.ir.scene_surface import SURFACE_NAMES
from roadlang.scenes.figure_colors import FIGURE_COLORS
from roadlang.scenes.sampling import SamplingResult
from roadlang_standard.emit_svg import Svg
from roadlang_standard.svg import palette
from tests.backends.svg_shapes import points

Sample = Callable[..., SamplingResult]
SVG = "{http://www.w3.org/2000/svg}"
STREET = """
road main {
  draw with waypoints { points: [(0m, 0m), (100m, 0m)] }
  left: [drive(3m), bike(1.5m), sidewalk(2m)]
  right: [drive(3m), parking(2m)]
}
"""


def paths(scene: Scene, group: str) -> list[ElementTree.Element]:
    root = ElementTree.fromstring(Svg().files(scene)["svg"])
    groups = [g for g in root.iter(f"{SVG}g") if g.get("class") == group]
    return [path for g in groups for path in g.iter(f"{SVG}path")]


@pytest.fixture
def street(sample: Sample) -> Scene:
    (scene,) = sample(STREET).scenes
    return scene


def changed(scene: Scene, marking: str) -> Scene:
    """The line between the directions marked in another way."""

    def of(road: SceneRoad) -> SceneRoad:
        return replace(road, center_marking=marking)  # type: ignore[arg-type]

    return replace(scene, roads=tuple(of(road) for road in scene.roads))


def test_each_lane_beside_the_roadway_has_the_color_of_its_kind(street: Scene) -> None:
    colors = [path.get("fill") for path in paths(street, "lanes")]
    assert colors == [palette.LANES[kind] for kind in ("sidewalk", "bike", "parking")]


def test_a_curb_is_drawn_where_a_lane_is_raised(street: Scene) -> None:
    strokes = [path.get("stroke") for path in paths(street, "markings")]
    assert strokes.count(palette.CURB) == 1


@pytest.mark.parametrize(
    ("marking", "more"), [("none", -1), ("solid", 0), ("broken", 0), ("double", 1), ("curb", 0)]
)
def test_a_marking_is_one_line_but_for_the_double_one(
    street: Scene, marking: str, more: int
) -> None:
    usual = len(paths(street, "markings"))
    assert len(paths(changed(street, marking), "markings")) == usual + more


def test_only_broken_lines_are_dashed(street: Scene) -> None:
    def dashed(scene: Scene) -> int:
        lines = paths(scene, "markings")
        return sum(path.get("stroke-dasharray") is not None for path in lines)

    assert dashed(street) == 1
    assert dashed(changed(street, "solid")) == 0


def test_a_scene_that_does_not_list_its_lanes_is_drawn_with_equal_ones(street: Scene) -> None:
    (main,) = street.roads
    old = replace(street, roads=(replace(main, lane_list=(), lanes=3),))
    assert paths(old, "lanes") == []
    assert len(paths(old, "markings")) == 4


def test_a_patch_has_the_color_of_its_surface_where_it_is(sample: Sample) -> None:
    """Ice on the right half from 40 m to 60 m of a road of gravel: as long as a fifth of the road,
    and on the other side of its middle than what is left."""
    text = STREET.split("left:")[0] + (
        "lanes: 2, width: 8m, surface: gravel\n"
        "surface_patches: [{ surface: ice, over: [40m, 60m], side: right }]\n}"
    )
    (scene,) = sample(text).scenes
    root = ElementTree.fromstring(Svg().files(scene)["svg"])
    drawn = {
        name: [points(path) for path in root.iter(f"{SVG}path") if path.get("fill") == color]
        for name in SURFACE_NAMES
        if (color := FIGURE_COLORS.of_surface(name)) is not None
    }
    assert {name for name, found in drawn.items() if found} == {"gravel", "ice"}
    (ice,) = drawn["ice"]
    everywhere = [point for shape in drawn["gravel"] for point in shape] + ice
    left, right = min(x for x, _ in everywhere), max(x for x, _ in everywhere)
    top, bottom = min(y for _, y in everywhere), max(y for _, y in everywhere)
    length = right - left
    assert [(min(x for x, _ in ice) - left) / length, (max(x for x, _ in ice) - left) / length] == (
        pytest.approx([0.4, 0.6], abs=0.01)
    )
    assert min(y for _, y in ice) == pytest.approx((top + bottom) / 2, abs=1.5)
    assert max(y for _, y in ice) == pytest.approx(bottom, abs=1.5)
