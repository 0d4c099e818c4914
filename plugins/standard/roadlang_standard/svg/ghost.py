"""Roads that are not the road itself: its original as a ghost, routes, versions, context."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from . import palette
from .labels import end_label
from .markup import element, group, path_data

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
    shapes, shown = [], list(roads)
    for index, ribbon in enumerate(shown):
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
        shapes.append(end_label(ribbon, shown[:index], size, color))
    return group(shapes, class_="versions")


def routes(roads: Iterable[Ribbon], size: float) -> str:
    """Roads that run on a network: a band along the streets that they take, with their names."""
    bands, shown = [], list(roads)
    for index, ribbon in enumerate(shown):
        color = palette.agent_color(index)
        bands.append(
            element("path", d=path_data(ribbon.line(0.0)), fill="none", stroke=color,
                    stroke_opacity=0.55, stroke_width=max(0.6 * float(ribbon.half.mean()), 2.0),
                    stroke_linejoin="round", stroke_linecap="round")
        )  # fmt: skip
        bands.append(end_label(ribbon, shown[:index], size, color))
    return group(bands, class_="routes")


def context(others: Iterable[Ribbon]) -> str:
    """Roads of the source that are neither driven nor an original: a pale band."""
    bands = [
        element("path", d=path_data(ribbon.outline(), closed=True), fill=palette.CONTEXT)
        for ribbon in others
    ]
    return group(bands, class_="context")
