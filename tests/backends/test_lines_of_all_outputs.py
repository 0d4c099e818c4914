"""The lines along lanes in figures, meshes and the Godot engine: one rule, so the same lines."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roadlang import testing
from roadlang.geometry import LINE_WIDTH, PARKING_SPACE, border_lines
from roadlang.geometry.lanes.dash_pattern import PERIOD
from roadlang.geometry.lanes.lane_paint import DASH, DOUBLE_APART, EDGE_INSET, GAP
from roadlang.geometry.lanes.lanes import MARKINGS, Marking
from roadlang.ir.scene import Scene, SceneRoad
from roadlang_formats.emit_gltf import GltfBackend
from roadlang_godot.build.lane_strips import LaneStrip, StripLine, lane_strips
from roadlang_godot.engines import engine as engines
from roadlang_standard.lane_looks import PAINT, LaneLook
from roadlang_standard.svg.lanes import lane_lines
from roadlang_standard.svg.ribbon import ribbon_of
from tests.backends.svg_shapes import PAGE, of, points
from tests.formats.glb_reader import ReadGlb

LENGTH = 90.0
WIDTHS = (2.0, 3.0, 3.5, 1.5)
"""Of a sidewalk, two lanes and a bike lane, from left to right"""
SCENE = """road main {
  left: [drive(3m), sidewalk(2m)], right: [drive(3.5m), bike(1.5m)]
  draw with waypoints { points: [(5m, 20m), (95m, 20m)] }
}"""

Line = tuple[float, bool]
"""How far north of the reference line, meters, and whether it is broken."""


def marked(edge: Marking, curb: Marking, center: Marking, other: Marking) -> Scene:
    """Lines at the outer edges, below the curb, in the middle and beside the bike lane."""
    scene = testing.sample(SCENE)[0].record
    (main,) = scene.roads
    by_id = {2: edge, 1: curb, -1: other, -2: edge}
    lanes = tuple(replace(lane, marking=by_id[lane.id]) for lane in main.lane_list)
    road = replace(main, lane_list=lanes, center_marking=center)
    return replace(scene, roads=(road,))


def offsets(road: SceneRoad) -> list[float]:
    borders = road.cross_section().border_offsets(np.array([LENGTH / 2]))[:, 0]
    return [float(border) for border in borders]


def by_rule(road: SceneRoad) -> list[Line]:
    section, borders = road.cross_section(), offsets(road)
    lines = border_lines(section.lanes, section.markings)
    return sorted((borders[x.border] + x.shift, x.is_broken) for x in lines if not x.is_curb)


def in_mesh(scene: Scene) -> list[Line]:
    file = ReadGlb.of(GltfBackend().files(scene)["glb"])
    if "main markings" not in file.nodes:
        return []
    triangles = file.triangles("main markings")
    found: dict[float, list[float]] = {}
    for triangle in triangles:
        low, high = triangle[:, 1].min(), triangle[:, 1].max()
        assert high - low == pytest.approx(LINE_WIDTH, abs=1e-4)
        found.setdefault(round(float(low + high) / 2 - 20.0, 3), []).append(np.ptp(triangle[:, 0]))
    return sorted((y, sum(lengths) / 2 < 0.9 * LENGTH) for y, lengths in found.items())


def in_engine(road: SceneRoad) -> list[Line]:
    """As the shader paints them; once a line on a border, of which two strips show a half each."""
    borders = offsets(road)
    found = set()
    for strip in lane_strips(road.cross_section()):
        for place, inward, line in ((strip.first, -1, strip.left), (strip.last, 1, strip.right)):
            found |= set(painted(borders[place], inward, line))
        found |= dividers(borders, strip)
    return sorted(found)


def painted(border: float, inward: int, line: StripLine) -> Iterable[Line]:
    broken = line in (StripLine.BROKEN, StripLine.INSIDE_BROKEN)
    if line in (StripLine.SOLID, StripLine.BROKEN):
        yield border, broken
    if line == StripLine.DOUBLE:
        yield border + inward * DOUBLE_APART, broken
    if line in (StripLine.INSIDE_SOLID, StripLine.INSIDE_BROKEN):
        yield border + inward * EDGE_INSET, broken
    if line == StripLine.INSIDE_DOUBLE:
        for apart in (DOUBLE_APART, -DOUBLE_APART):
            yield border + inward * EDGE_INSET + apart, broken


def dividers(borders: list[float], strip: LaneStrip) -> set[Line]:
    inner = range(strip.first + 1, strip.last) if strip.surface == LaneLook.ROADWAY else ()
    return {(borders[place], True) for place in inner}


def in_figure(road: SceneRoad) -> list[tuple[int, bool]]:
    """The side of its border that a line lies on, in the order of `by_rule`, and whether it is
    broken: figures draw lines wider than they are, so that they can be seen."""
    ribbon = ribbon_of(road, PAGE)
    drawn = of(lane_lines(ribbon, 40.0, PAGE.pixels_per_meter), "path")
    lines = [
        (points(line)[0][1] / 10.0, line.get("stroke-dasharray") is not None)
        for line in drawn
        if line.get("stroke") != "#dedace"
    ]
    return nearest([(30.0 - y, broken) for y, broken in lines], offsets(road))


def nearest(lines: Iterable[Line], borders: list[float]) -> list[tuple[int, bool]]:
    """Which border is nearest to each line, and whether it is broken."""
    return sorted((int(np.argmin(np.abs(np.subtract(borders, y)))), b) for y, b in lines)


@pytest.mark.parametrize("edge", MARKINGS)
@pytest.mark.parametrize("inner", MARKINGS)
def test_all_outputs_have_the_same_lines(edge: Marking, inner: Marking) -> None:
    for scene in (marked(edge, inner, "broken", "solid"), marked("none", edge, inner, inner)):
        (road,) = scene.roads
        lines = by_rule(road)
        for found in (in_mesh(scene), in_engine(road)):
            assert [broken for _, broken in found] == [broken for _, broken in lines]
            assert [y for y, _ in found] == pytest.approx([y for y, _ in lines], abs=1e-3)
        assert in_figure(road) == nearest(lines, offsets(road))


def constants(path: Path) -> dict[str, float]:
    rows = re.findall(r"^const (?:float|int) (\w+) = ([\d.]+);", path.read_text(), re.MULTILINE)
    return {name: float(value) for name, value in rows}


def test_the_shader_of_roads_paints_by_the_numbers_of_the_rule() -> None:
    found = constants(engines.project() / "build/shaders/road.gdshader")
    expected = {
        "LINE": LINE_WIDTH,
        "EDGE_INSET": EDGE_INSET,
        "DOUBLE_APART": DOUBLE_APART,
        "DASH": DASH,
        "DASH_PERIOD": PERIOD,
        "CURB_LINE": StripLine.CURB,
        **{line.name: line for line in StripLine if line > 1 and line != StripLine.CURB},
    }
    assert {name: found[name] for name in expected} == expected


def test_the_exporter_asks_the_shader_for_numbers_that_it_has() -> None:
    """By name; it would take a missing one for 0."""
    folder = engines.project()
    text = (folder / "export/lane_paint.gd").read_text()
    asked = set(re.findall(r'(?:size\.call|shader, )\(?"(\w+)"', text))
    assert {"LINE", "CURB", "INSIDE_SOLID"} <= asked
    assert asked <= set(constants(folder / "build/shaders/road.gdshader"))


def test_lanes_have_the_colors_of_their_looks_in_the_engine() -> None:
    looks = (engines.project() / "build/looks.gd").read_text()
    rows = re.findall(r"\[Color\(([\d., ]+)\), ([\d.]+), (true|false)\]", looks)
    colors = [hexadecimal(row[0]) for row in rows]
    assert colors == [look.color for look in LaneLook]
    assert float(rows[LaneLook.PARKING][1]) == PARKING_SPACE


def test_paint_has_one_color_in_the_engine() -> None:
    folder = engines.project() / "build"
    (lines,) = re.findall(
        r"paint : source_color = vec3\((.+)\)", (folder / "shaders/road.gdshader").read_text()
    )
    (shapes,) = re.findall(r"plain\(Color\((.+?)\)", (folder / "paint.gd").read_text())
    assert {hexadecimal(lines), hexadecimal(shapes)} == {PAINT}


def hexadecimal(parts: str) -> str:
    return "#" + "".join(f"{int(255 * float(part) + 0.5):02x}" for part in parts.split(","))


def test_broken_lines_of_a_report_have_the_proportions_of_the_rule() -> None:
    page = Path(testing.__file__).parent / "report/page/page.css"
    ((dash, gap),) = re.findall(r"broken \{ stroke-dasharray: ([\d.]+) ([\d.]+)", page.read_text())
    assert (float(dash), float(gap)) == (DASH, GAP)
