"""Junctions: one surface each, its curb, and what is painted at its edge."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from . import palette
from .markup import element, path_data

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneJunction
    from roadlang.geometry import Floats

    from .viewport import Viewport

_SMALLEST_ARROW = 2.5
"""Pixels of a meter, below which arrows are left out and the stripes of crossings blur."""
_LEAST_LINE, _LEAST_THIN = 1.4, 0.4
"""Pixels; of arrows and of lines along lanes the latter"""
_ACROSS = ("stop_line", "yield_line")


def surface(junction: SceneJunction, viewport: Viewport, fill: str | None = None) -> str:
    """Its area."""
    ring = path_data(viewport.place(junction.area), closed=True)
    return element("path", d=ring, fill=fill, stroke_width=0)


def curbs(junction: SceneJunction, viewport: Viewport, width: float) -> Iterator[str]:
    """The lines round its area, but where roads begin."""
    import numpy as np

    ring = viewport.place(junction.area)
    inner = ring + width / 2.0 * _inward(ring)
    count = len(ring)
    faces = {frozenset((arm.left, arm.right)) for arm in junction.arms}
    breaks = [i for i in range(count) if frozenset((i, (i + 1) % count)) in faces]
    for place, first in enumerate(breaks):
        last = breaks[(place + 1) % len(breaks)]
        length = (last - first - 1) % count
        line = inner[(first + 1 + np.arange(length + 1)) % count]
        if length:
            yield element(
                "path", d=path_data(line), fill="none", stroke=palette.CASING, stroke_width=width
            )


def _inward(ring: Floats) -> Floats:
    """(n, 2) unit vectors into a ring that runs clockwise in pixels (y is down)."""
    import numpy as np

    step = np.roll(ring, -1, axis=0) - ring
    normal = np.stack([step[:, 1], -step[:, 0]], axis=-1)
    normal /= np.maximum(np.hypot(*normal.T), 1e-9)[:, None]
    both = normal + np.roll(normal, 1, axis=0)
    return np.asarray(both / np.maximum(np.hypot(*both.T), 1e-9)[:, None])


def paint(scene: Scene, junctions: Sequence[SceneJunction], viewport: Viewport) -> Iterator[str]:
    """Stop lines, lines to yield at, turn arrows, zebra crossings and lines that go on; and the
    crosswalks between junctions."""
    from roadlang.api import crosswalk_paint, junction_paint

    scale = viewport.pixels_per_meter
    for shape in (*junction_paint(scene, junctions), *crosswalk_paint(scene)):
        small = scale < _SMALLEST_ARROW
        if shape.kind == "arrow" and small:
            continue
        line = path_data(viewport.place(shape.points), closed=not shape.width)
        if not shape.width:
            color = palette.FAINT_MARKING if shape.kind == "crossing" and small else palette.MARKING
            yield element("path", d=line, fill=color)
            continue
        least = _LEAST_LINE if shape.kind in _ACROSS else _LEAST_THIN
        dashes = shape.dashes and " ".join(f"{part * scale:.2f}" for part in shape.dashes)
        yield element("path", d=line, fill="none", stroke=palette.MARKING,
                      stroke_width=max(shape.width * scale, least),
                      stroke_dasharray=dashes)  # fmt: skip


def heads(junctions: Sequence[SceneJunction], viewport: Viewport) -> Iterator[str]:
    """The signals beside the stop lines, with the light of the first moment."""
    from roadlang.api import signal_heads

    for junction in junctions:
        for head in signal_heads(junction):
            x, y = viewport.place([head.x, head.y]).tolist()
            color = junction.control.light(head.connections[0], 0.0)
            yield _head(x, y, color, viewport.pixels_per_meter)


def _head(x: float, y: float, color: str, scale: float) -> str:
    size = max(0.55 * scale, 2.6)
    return element("circle", cx=x, cy=y, r=size, fill=palette.LIGHTS[color],
                   stroke=palette.INK, stroke_width=0.35 * size)  # fmt: skip
