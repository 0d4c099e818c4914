"""Roads that are not the road itself: its original as a ghost, routes, versions, context."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from . import palette
from .markup import element, group, path_data, text

if TYPE_CHECKING:
    from .ribbon import Ribbon


def ghosts(originals: Iterable[Ribbon]) -> str:
    """The original roads, translucent with a dashed outline and center line."""
    shapes = []
    for ribbon in originals:
        shapes.append(
            element(
                "path",
                d=path_data(ribbon.outline(), closed=True),
                fill=palette.GHOST_FILL,
                fill_opacity=0.30,
                stroke=palette.GHOST_LINE,
                stroke_opacity=0.75,
                stroke_width=0.9,
                stroke_dasharray="5 3.5",
            )
        )
    return group(shapes, class_="ghosts")


def ghost_lines(originals: Iterable[Ribbon]) -> str:
    """The original center lines, over the new road, so that the displacement can be seen."""
    lines = [
        element(
            "path",
            d=path_data(ribbon.line(0.0)),
            fill="none",
            stroke=palette.GHOST_LINE,
            stroke_opacity=0.85,
            stroke_width=1.1,
            stroke_dasharray="5 3.5",
        )
        for ribbon in originals
    ]
    return group(lines, class_="ghost-lines")


def versions(roads: Iterable[Ribbon], size: float) -> str:
    """Roads of one root: translucent, each in its color, with its name where it ends."""
    shapes = []
    for index, ribbon in enumerate(roads):
        color = palette.agent_color(index)
        surface = path_data(ribbon.outline(), closed=True)
        shapes.append(
            element("path", d=surface, fill=color, fill_opacity=0.30, stroke=color,
                    stroke_width=1.4, stroke_linejoin="round")
        )  # fmt: skip
        shapes.append(
            element("path", d=path_data(ribbon.line(0.0)), fill="none", stroke=color,
                    stroke_width=1.0, stroke_dasharray="7 5")
        )  # fmt: skip
        x, y = ribbon.center[-1].tolist()
        shapes.append(
            text(ribbon.name, x, y + (1.3 * index - 0.9) * size, text_anchor="middle",
                 font_size=size, font_weight="600", fill=color, stroke=palette.GROUND,
                 stroke_width=3.0, paint_order="stroke")
        )  # fmt: skip
    return group(shapes, class_="versions")


def routes(roads: Iterable[Ribbon]) -> str:
    """Roads that run on a network: a band along the streets that they take."""
    bands = [
        element("path", d=path_data(ribbon.line(0.0)), fill="none",
                stroke=palette.agent_color(index), stroke_opacity=0.55,
                stroke_width=max(0.6 * float(ribbon.half.mean()), 2.0), stroke_linejoin="round",
                stroke_linecap="round")
        for index, ribbon in enumerate(roads)
    ]  # fmt: skip
    return group(bands, class_="routes")


def context(others: Iterable[Ribbon]) -> str:
    """Roads of the source that are neither driven nor an original: a pale band."""
    bands = [
        element("path", d=path_data(ribbon.outline(), closed=True), fill=palette.CONTEXT)
        for ribbon in others
    ]
    return group(bands, class_="context")
