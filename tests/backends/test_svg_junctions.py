"""`emit svg` of junctions: one surface, its curb, and what is painted at its edge."""

from __future__ import annotations

from collections.abc import Callable
from xml.etree import ElementTree

import pytest

from roadlang.api import junction_paint
from roadlang.scenes.sampling import SamplingResult
from roadlang_standard.emit_svg import Svg
from roadlang_standard.svg.junctions import paint
from roadlang_standard.svg.palette import FAINT_MARKING, LIGHTS, MARKING
from roadlang_standard.svg.viewport import BoundingBox, Viewport

SVG = "{http://www.w3.org/2000/svg}"
PLAN = '''
image plan from """
...#........#...
################
...#............
""" { scale: 20m/px, legend: { "#": road } }
network town from plan { CONTROL }
'''


def junction_figure(sample: Callable[..., SamplingResult], control: str) -> ElementTree.Element:
    scene = sample(PLAN.replace("CONTROL", control)).scenes[0]
    return ElementTree.fromstring(Svg().files(scene)["svg"])


def group_of(figure: ElementTree.Element, name: str) -> list[ElementTree.Element]:
    return [child for g in figure.iter(f"{SVG}g") if g.get("class") == name for child in g]


def test_junctions_have_a_curb_between_the_roads(sample: Callable[..., SamplingResult]) -> None:
    """A crossing of four roads has four corners, one of three roads two and a straight side."""
    figure = junction_figure(sample, "")
    assert len(group_of(figure, "curbs")) == 7
    assert len(group_of(figure, "paint")) == 7, "an edge line along each, and nothing else"


def test_lines_are_painted_where_traffic_stops(sample: Callable[..., SamplingResult]) -> None:
    lines = group_of(junction_figure(sample, "control with all_way_stop"), "paint")
    widths = [float(line.get("stroke-width") or 0.0) for line in lines]
    stops = [line for line, width in zip(lines, widths, strict=True) if width == max(widths)]
    assert len(stops) == 7
    assert all(line.get("stroke-dasharray") is None for line in stops)
    painted = group_of(junction_figure(sample, "control with yield"), "paint")
    yields = [line for line in painted if line.get("stroke-dasharray")]
    assert len(yields) == 3, "the others are the lines of the road that goes first"


def test_signals_show_the_light_of_the_first_moment(
    sample: Callable[..., SamplingResult],
) -> None:
    heads = group_of(junction_figure(sample, "control with signals"), "signals")
    colors = sorted(str(head.get("fill")) for head in heads)
    assert len(heads) == 7
    assert colors.count(LIGHTS["green"]) in (3, 4)
    assert colors.count(LIGHTS["red"]) == 7 - colors.count(LIGHTS["green"])


@pytest.mark.parametrize("scale", [1.0, 2.4, 2.5, 8.0])
def test_small_figures_have_no_arrows_faint_crossings_and_lines_that_can_be_seen(
    sample: Callable[..., SamplingResult], scale: float
) -> None:
    text = PLAN.replace("CONTROL", "lanes: 4, sidewalks: 2m, control with signals")
    scene = sample(text).scenes[0]
    junctions = scene.networks[0].junctions
    shapes = list(junction_paint(scene, junctions))
    assert {shape.kind for shape in shapes} >= {"arrow", "crossing", "stop_line"}
    small = scale < 2.5
    shown = [shape for shape in shapes if not (small and shape.kind == "arrow")]
    box = BoundingBox(0.0, 0.0, 400.0, 100.0)
    drawn = paint(scene, junctions, Viewport(box, 0.0, 0.0, 400.0 * scale, 100.0 * scale))
    for shape, written in zip(shown, drawn, strict=True):
        element = ElementTree.fromstring(written)
        if not shape.width:
            faint = small and shape.kind == "crossing"
            assert element.get("fill") == (FAINT_MARKING if faint else MARKING), shape.kind
            continue
        width = float(element.get("stroke-width") or 0.0)
        least = 1.4 if shape.kind in ("stop_line", "yield_line") else 0.4
        assert width == pytest.approx(max(shape.width * scale, least), abs=0.01), shape.kind
        dashes = [float(part) for part in (element.get("stroke-dasharray") or "").split()]
        assert dashes == pytest.approx([part * scale for part in shape.dashes or ()], abs=0.01)
