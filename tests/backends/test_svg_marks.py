"""Marks on the roads of a figure, by hand: where requirements are violated, where nearly so."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.ir.scene import RoadPlace, Verdict, ViolatedSegment
from roadlang_standard.svg import palette
from roadlang_standard.svg.labels import PixelBox
from roadlang_standard.svg.ribbon import ribbon_of
from roadlang_standard.svg.tightest import tight_places
from roadlang_standard.svg.violations import violations
from tests.backends.handmade_scenes import bend, through
from tests.backends.svg_shapes import (
    PAGE,
    ends,
    numbers,
    of,
    shapes,
    straight_ribbon,
    written,
)

FONT = 10.0


def near(*values: float) -> object:
    return pytest.approx(values, abs=0.02)


def painted(drawn: str, tag: str, *names: str) -> list[list[str | None]]:
    return [[shape.get(name) for name in names] for shape in of(drawn, tag)]


def judged(*segments: ViolatedSegment, name: str = "calm") -> Verdict:
    return replace(bend().expectations[0], name=name, violated=segments)


def test_violations_are_bands_beside_the_left_edge_one_beyond_the_other() -> None:
    """4 px each: the first begins 3.6 px outside the edge, the second 7.6 px."""
    segment = ViolatedSegment("main", 20.0, 30.0)
    first, second = judged(segment), judged(segment, name="slow")
    scene = replace(bend(), requirements=(), expectations=(first, second))
    band, area, other = of(violations(scene, {"main": straight_ribbon()}), "path")
    assert ends(band) == near(200, 206.4, 300, 206.4)
    assert ends(other) == near(200, 202.4, 300, 202.4)
    assert numbers(band, "stroke-width") == near(3.2)
    assert [band.get("stroke"), other.get("stroke")] == list(palette.VIOLATIONS[:2])
    assert ends(area) == near(200, 210, 200, 290)
    hints = [
        shape.text
        for shape in shapes(violations(scene, {"main": straight_ribbon()}))
        if shape.tag == "title"
    ]
    assert hints == [f"{name} violated: 20.0 m to 30.0 m" for name in ("calm", "slow")]


def test_a_violation_at_one_place_is_a_dash_of_2_pixels() -> None:
    scene = replace(bend(), requirements=(),
                    expectations=(judged(ViolatedSegment("main", 50.0, 50.0)),))  # fmt: skip
    dash = of(violations(scene, {"main": straight_ribbon()}), "path")[0]
    assert ends(dash) == near(499, 206.4, 501, 206.4)


def test_a_violation_of_a_network_is_marked_on_its_roads() -> None:
    scene = replace(bend(), requirements=(),
                    expectations=(judged(ViolatedSegment("town", 20.0, 30.0)),))  # fmt: skip
    ribbons = {name: straight_ribbon() for name in ("town/1", "town/2", "township/1")}
    assert len(of(violations(scene, ribbons), "path")) == 4


def pins(*places: float, **changes: Any) -> str:
    verdicts = [
        replace(bend().requirements[0], name=f"r{index}", tightest=RoadPlace("main", place))
        for index, place in enumerate(places)
    ]
    scene = replace(bend(), requirements=tuple(verdicts), expectations=())
    return tight_places(scene, {"main": straight_ribbon(**changes)}, FONT)


def test_a_pin_stands_at_the_left_edge_with_the_name_beyond() -> None:
    """Its foot is 3 px outside the edge at 210, its head 11 px further, the name over it."""
    drawn = pins(50.0)
    (line,), (foot,) = of(drawn, "line"), of(drawn, "circle")
    assert numbers(line, "x1", "y1", "x2", "y2") == near(500, 207, 500, 196)
    assert numbers(foot, "cx", "cy", "r") == near(500, 207, 2.4)
    ((name, x, y),) = written(drawn)
    assert name == "r0"
    assert (x, y) == near(500, 194.5)
    hints = [shape.text for shape in of(drawn, "title")]
    assert hints == ["r0 is tightest here: \N{GREEK SMALL LETTER RHO} = 4"]


def test_a_pin_is_longer_where_its_name_would_be_on_a_number() -> None:
    verdict = replace(bend().requirements[0], name="r0", tightest=RoadPlace("main", 50.0))
    scene = replace(bend(), requirements=(verdict,), expectations=())
    number = PixelBox(490, 185, 510, 195)
    for taken, y in (([], 194.5), ([number], 182.5), ([PixelBox(0, 0, 1000, 500)], 194.5)):
        drawn = tight_places(scene, {"main": straight_ribbon()}, FONT, taken)
        assert [spot for _, _, spot in written(drawn)] == near(y)


def test_pins_nearer_than_34_pixels_share_one() -> None:
    assert [name for name, _, _ in written(pins(50.0, 53.3))] == ["r0, r1"]
    assert [name for name, _, _ in written(pins(50.0, 53.5))] == ["r0", "r1"]


@pytest.mark.parametrize(
    ("heading", "anchor", "dx", "dy"),
    [(0.0, "middle", 0, -1.5), (np.pi, "middle", 0, 7.5),
     (np.pi / 2, "end", -2.5, 3.0), (-np.pi / 2, "start", 2.5, 3.0)],
)  # fmt: skip
def test_the_name_of_a_pin_is_on_the_side_away_from_the_road(
    heading: float, anchor: str, dx: float, dy: float
) -> None:
    steps = np.linspace(-20, 20, 400)
    line = through("main", [(50 + s * np.cos(heading), 25 + s * np.sin(heading)) for s in steps])
    verdict = replace(bend().requirements[0], tightest=RoadPlace("main", 20.0))
    scene = replace(bend(), requirements=(verdict,), expectations=())
    drawn = tight_places(scene, {"main": ribbon_of(line, PAGE)}, FONT)
    (stem,), (name,) = of(drawn, "line"), of(drawn, "text")
    assert name.get("text-anchor") == anchor
    tip, spot = numbers(stem, "x2", "y2"), numbers(name, "x", "y")
    assert [spot[0] - tip[0], spot[1] - tip[1]] == near(dx, dy)


def test_pins_have_a_halo_of_the_ground() -> None:
    assert painted(pins(50.0), "g", "stroke", "paint-order", "fill")[0] == [
        palette.GROUND, "stroke", palette.TIGHT
    ]  # fmt: skip


def test_violations_are_bright_bands_and_a_tint_of_the_road() -> None:
    scene = replace(bend(), requirements=(),
                    expectations=(judged(ViolatedSegment("main", 20.0, 30.0)),))  # fmt: skip
    looks = ("fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-linecap")
    color = palette.VIOLATIONS[0]
    assert painted(violations(scene, {"main": straight_ribbon()}), "path", *looks) == [
        [None, None, color, "0.9", "round"], [color, "0.28", None, None, None]
    ]  # fmt: skip
    assert painted(violations(scene, {"main": straight_ribbon()}), "g", "fill") == [["none"]]
