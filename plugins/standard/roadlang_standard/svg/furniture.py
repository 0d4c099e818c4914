"""What makes a drawing a map: frame, scale bar, north arrow, arc-length marks."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from roadlang.api import geometry

from . import palette
from .labels import PixelBox
from .markup import element, group, text
from .wrapping import LETTER

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import Scene
    from roadlang.geometry import Floats

    from .ribbon import Ribbon
    from .viewport import Viewport

_BAR_SHARE = 0.18
_MARK_SPACING = 95.0


def ground(viewport: Viewport) -> str:
    """The map's background."""
    return element("rect", **_rectangle(viewport), rx=3.0, fill=palette.GROUND)


def frame(viewport: Viewport) -> str:
    """The outline of a viewport."""
    return element(
        "rect",
        **_rectangle(viewport),
        rx=3.0,
        fill="none",
        stroke=palette.GROUND_EDGE,
        stroke_width=1.0,
    )


def clip(viewport: Viewport, name: str) -> str:
    """A clip path of the map's rectangle."""
    shape = element("rect", **_rectangle(viewport), rx=3.0)
    return element("clipPath", shape, id=name)


def scale_bar(viewport: Viewport, size: float, right: float, y: float) -> str:
    """Two-tone, of a round length, its right end at `right` and its top at `y`."""
    meters = geometry.round_length(_BAR_SHARE * viewport.box.width)
    long = meters * viewport.pixels_per_meter
    left, thick = right - long, 5.0
    half = long / 2
    bar = [
        element("rect", x=left, y=y, width=half, height=thick, fill=palette.INK),
        element("rect", x=left + half, y=y, width=half, height=thick, fill="#ffffff"),
        element("rect", x=left, y=y, width=long, height=thick, fill="none",
                stroke=palette.INK, stroke_width=0.8),
    ]  # fmt: skip
    below = y + thick + 1.15 * size
    ticks = [(left, "0"), (left + half, _bare(meters / 2, meters)), (right, _length_text(meters))]
    bar += [text(label, x, below, text_anchor="middle") for x, label in ticks]
    return group(bar, class_="scale-bar", font_size=0.9 * size, fill=palette.INK)


def north_arrow(x: float, y: float, size: float) -> str:
    """A needle with its tip up and an N; (x, y) is its center."""
    h, w = 1.5 * size, 0.62 * size
    lit = f"{x:.2f},{y - h:.2f} {x:.2f},{y + 0.45 * h:.2f} {x - w:.2f},{y + 0.8 * h:.2f}"
    dark = f"{x:.2f},{y - h:.2f} {x:.2f},{y + 0.45 * h:.2f} {x + w:.2f},{y + 0.8 * h:.2f}"
    line = {"stroke": palette.INK, "stroke_width": 0.9, "stroke_linejoin": "round"}
    return group(
        [
            element("polygon", points=lit, fill="#ffffff", **line),
            element("polygon", points=dark, fill=palette.INK, **line),
            text("N", x, y - h - 0.35 * size, text_anchor="middle", font_size=size,
                 font_weight="700", fill=palette.INK),
        ],
        class_="north",
    )  # fmt: skip


def world_note(scene: Scene, viewport: Viewport, size: float) -> str:
    """What `world` says, in the map's lower right corner: `rain · 18:30 · friction 0.70`."""
    note = " · ".join(_world_parts(scene.world))
    if not note:
        return ""
    x, y = viewport.x + viewport.width - 0.8 * size, viewport.y + viewport.height - 0.8 * size
    return text(note, x, y, text_anchor="end", font_size=0.9 * size, fill=palette.MUTED_INK,
                stroke=palette.GROUND, stroke_width=2.6, paint_order="stroke")  # fmt: skip


def _world_parts(world: Mapping[str, object]) -> Iterator[str]:
    weather, time, friction = (world.get(key) for key in ("weather", "time_of_day", "friction"))
    if isinstance(weather, str):
        yield weather
    if isinstance(time, int | float):
        minutes = round(time / 60)
        yield f"{minutes // 60 % 24:02d}:{minutes % 60:02d}"
    if isinstance(friction, int | float):
        yield f"friction {friction:.2f}"


def station_marks(
    ribbon: Ribbon, viewport: Viewport, size: float, surfaces: Sequence[Floats] = ()
) -> str:
    """Ticks at round arc lengths of the root road, the positions of the requirements: beside the
    right edge, or beside the left one where fewer numbers would be on the `surfaces` of other
    roads (polygons in pixels). Numbers that would still be on one are left out."""
    return group(
        _marks(ribbon, viewport, size, surfaces),
        class_="stations",
        font_size=0.8 * size,
        fill=palette.MUTED_INK,
        stroke=palette.MUTED_INK,
    )


def _marks(
    ribbon: Ribbon, viewport: Viewport, size: float, surfaces: Sequence[Floats]
) -> Iterator[str]:
    for label, (x1, y1, x2, y2), (x, y) in _places(ribbon, viewport, size, surfaces):
        yield element("line", x1=x1, y1=y1, x2=x2, y2=y2, stroke_width=0.9)
        if math.isfinite(x) and math.isfinite(y):
            yield text(label, x, y + 0.28 * size, text_anchor="middle",
                       stroke=palette.GROUND, stroke_width=2.6, paint_order="stroke")  # fmt: skip


def station_boxes(
    ribbon: Ribbon, viewport: Viewport, size: float, surfaces: Sequence[Floats] = ()
) -> Iterator[PixelBox]:
    """What the numbers of `station_marks` take up."""
    for label, _, (x, y) in _places(ribbon, viewport, size, surfaces):
        yield PixelBox.around(x, y + 0.28 * size, LETTER * 0.8 * size * len(label), 0.8 * size)


def _places(
    ribbon: Ribbon, viewport: Viewport, size: float, surfaces: Sequence[Floats]
) -> Iterator[tuple[str, list[float], list[float]]]:
    """Of each mark: what is written, both ends of its tick, the middle of its text."""
    import numpy as np

    spacing = geometry.round_length(_MARK_SPACING / viewport.pixels_per_meter)
    last = float(ribbon.reference[-1])
    # On a closed road the last mark would stand on the first.
    furthest = last - 0.6 * spacing if ribbon.closed else last
    places = spacing * np.arange(int(furthest / spacing + 1e-9) + 1, dtype=np.float64)
    marks = ribbon.at(places, by_reference=True)
    sides = []
    for side in (-1.0, 1.0):
        edge, out = marks.line(side), side * marks.left
        lines = np.column_stack([edge + 1.5 * out, edge + 6.0 * out])
        spots = edge + (6.0 + 0.9 * size) * out
        sides.append((lines, spots, _covered(spots, 0.4 * size, surfaces)))
        if not sides[-1][-1].any():
            break
    lines, spots, covered = min(sides, key=lambda side: side[-1].sum())
    for s, line, spot, is_covered in zip(
        places.tolist(), lines.tolist(), spots.tolist(), covered.tolist(), strict=True
    ):
        if not is_covered:
            label = _length_text(s) if s == 0 or s + spacing > last else _bare(s, last)
            yield label, line, spot


def _covered(spots: Floats, reach: float, surfaces: Sequence[Floats]) -> NDArray[np.bool_]:
    """(n,) whether spots (n, 2) are on one of the surfaces, or nearer than `reach` pixels."""
    import numpy as np

    found = np.zeros(len(spots), dtype=np.bool_)
    for surface in surfaces:
        near = (spots > surface.min(axis=0) - reach) & (spots < surface.max(axis=0) + reach)
        asked = near.all(axis=1) & ~found
        if asked.any():
            found[asked] = geometry.outside_ring(surface, *spots[asked].T) < reach
    return found


def _length_text(meters: float) -> str:
    return f"{meters / 1000:g} km" if meters >= 1000 else f"{meters:g} m"


def _bare(meters: float, largest: float) -> str:
    """The number alone, in the unit that `largest` would be written in."""
    return f"{meters / 1000:g}" if largest >= 1000 else f"{meters:g}"


def _rectangle(viewport: Viewport) -> dict[str, object]:
    return {
        "x": viewport.x,
        "y": viewport.y,
        "width": viewport.width,
        "height": viewport.height,
    }
