"""Shapes as an SVG document: a map with a scale bar and a north arrow."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from roadlang_standard.svg import furniture, palette
from roadlang_standard.svg.drawing import Style, document
from roadlang_standard.svg.markup import element, group, path_data, text, title
from roadlang_standard.svg.viewport import BoundingBox, Viewport, fitted

from .shapes import PlanShape

_EDGE = 0.6
"""Pixels of the line around an area."""


def drawn(shapes: Sequence[PlanShape], name: str, width: float) -> str:
    """The SVG of at least one shape, `width` pixels wide."""
    size = Style(size=width).font
    pad = 1.2 * size
    top = pad + 2.3 * size
    viewport = fitted(_box(shapes), pad, top, width - 2.0 * pad)
    below = top + viewport.height + 0.9 * size
    right = viewport.x + viewport.width
    parts = [
        element("defs", furniture.clip(viewport, "map")),
        text(
            name, pad, pad + 1.2 * size, font_size=1.35 * size, font_weight="700", fill=palette.INK
        ),
        furniture.ground(viewport),
        group(_drawn_shapes(shapes, viewport), clip_path="url(#map)"),
        furniture.frame(viewport),
        furniture.north_arrow(right - 1.9 * size, viewport.y + 3.4 * size, size),
        furniture.scale_bar(viewport, size, width - pad - 2.2 * size, below + 0.3 * size),
    ]
    return document(parts, width, below + 2.6 * size + pad, name)


def _drawn_shapes(shapes: Sequence[PlanShape], viewport: Viewport) -> Iterator[str]:
    for shape in shapes:
        is_line = shape.width is not None
        data = "".join(path_data(viewport.place(line), not is_line) for line in shape.outlines)
        label = (title(shape.label),) if shape.label else ()
        if shape.width is not None:
            wide = max(shape.width * viewport.pixels_per_meter, _EDGE)
            yield element("path", *label, d=data, fill="none", stroke=shape.color,
                          stroke_width=wide, stroke_linejoin="round")  # fmt: skip
        else:
            # The line around closes the seams between neighbors.
            yield element("path", *label, d=data, fill=shape.color, stroke=shape.color,
                          stroke_width=_EDGE, stroke_linejoin="round")  # fmt: skip


def _box(shapes: Sequence[PlanShape]) -> BoundingBox:
    lines = np.concatenate([line for shape in shapes for line in shape.outlines])
    half = max((shape.width or 0.0) / 2.0 for shape in shapes)
    (left, bottom), (right, top) = (
        (lines.min(axis=0) - half).tolist(),
        (lines.max(axis=0) + half).tolist(),
    )
    return BoundingBox(left, bottom, right, top)
