"""Reads shapes out of SVG text, and a page on which they are easy to compute by hand."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any
from xml.etree import ElementTree

from roadlang.ir.scene import SceneRoad
from roadlang_standard.svg.ribbon import Ribbon, ribbon_of
from roadlang_standard.svg.viewport import BoundingBox, Viewport
from tests.backends.handmade_scenes import road

PAGE = Viewport(BoundingBox(0.0, 0.0, 100.0, 50.0), 0.0, 0.0, 1000.0, 500.0)
"""Ten pixels a meter: (x, y) meters are (10 x, 500 - 10 y) pixels."""

Shape = ElementTree.Element


def shapes(drawn: str | Iterable[str]) -> list[Shape]:
    """All elements of some SVG text, outermost first."""
    text = drawn if isinstance(drawn, str) else "".join(drawn)
    return list(ElementTree.fromstring(f"<all>{text}</all>").iter())[1:]


def of(drawn: str | Iterable[str], tag: str) -> list[Shape]:
    return [shape for shape in shapes(drawn) if shape.tag == tag]


def numbers(shape: Shape, *names: str) -> list[float]:
    """The values of these attributes."""
    return [float(shape.get(name) or "nan") for name in names]


def points(shape: Shape) -> list[tuple[float, float]]:
    """The points of a path or polygon."""
    text = shape.get("d") or shape.get("points") or ""
    pairs = re.findall(r"(-?[\d.]+)[ ,](-?[\d.]+)", text)
    return [(float(x), float(y)) for x, y in pairs]


def ends(shape: Shape) -> tuple[float, float, float, float]:
    """x and y of the first and the last point of a path."""
    return (*points(shape)[0], *points(shape)[-1])


def written(drawn: str | Iterable[str]) -> list[tuple[str, float, float]]:
    """Each text with its x and y."""
    found = []
    for shape in of(drawn, "text"):
        x, y = numbers(shape, "x", "y")
        found.append((shape.text or "", x, y))
    return found


def straight(y: float = 25.0, **changes: Any) -> SceneRoad:
    """A road eastward over 100 m, its two lanes 4 m wide: from 210 to 290 pixels on the page."""
    wide = {"width": (8.0,) * 400}
    return road("main", lambda x: y, 100.0, **{**wide, **changes})


def straight_ribbon(y: float = 25.0, **changes: Any) -> Ribbon:
    return ribbon_of(straight(y, **changes), PAGE)
