"""What was there before: the original road as a ghost, other roads of the source as context."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from . import palette
from .markup import element, group, path_data

if TYPE_CHECKING:
    from .ribbon import Ribbon


def ghosts(originals: Iterable[Ribbon]) -> str:
    """The original roads, translucent with a dashed outline and centre line."""
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
    """The original centre lines, over the new road, so that the displacement can be seen."""
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


def context(others: Iterable[Ribbon]) -> str:
    """Roads of the source that are neither driven nor an original: a pale band."""
    bands = [
        element("path", d=path_data(ribbon.outline(), closed=True), fill=palette.CONTEXT)
        for ribbon in others
    ]
    return group(bands, class_="context")
