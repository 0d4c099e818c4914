"""The ids of junctions and roads, as scene files name them: `junction(3)`, `road(7)`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from roadlang.api import shown_junctions

from . import palette
from .markup import group, text

if TYPE_CHECKING:
    from roadlang.api import Scene

    from .viewport import Viewport

_SHARE = 0.8
"""Size of the ids beside that of other labels"""


def network_ids(scene: Scene, names: Sequence[str], viewport: Viewport, font: float) -> str:
    """Of the networks that are drawn in full: bold in the middle of each junction, in italics
    amid each road."""
    return group(
        [*_junctions(scene, names, viewport), *_roads(scene, names, viewport)],
        class_="ids",
        font_size=_SHARE * font,
        fill=palette.INK,
        stroke="#ffffff",
        stroke_width=2.4,
        stroke_opacity=0.8,
        paint_order="stroke",
        text_anchor="middle",
    )


def _junctions(scene: Scene, names: Sequence[str], viewport: Viewport) -> Iterator[str]:
    for junction in shown_junctions(scene, set(names)):
        if junction.kind != "joint":
            x, y = viewport.place(np.array(junction.area).mean(axis=0)).tolist()
            yield text(str(junction.id), x, y, font_weight="700")


def _roads(scene: Scene, names: Sequence[str], viewport: Viewport) -> Iterator[str]:
    for road in scene.roads:
        if road.network is None or road.edge is None or road.name not in names:
            continue
        if sum(road.trim) < road.length:
            amid = 0.5 * (road.trim[0] + road.length - road.trim[1])
            point = int(np.abs(np.asarray(road.stations) - amid).argmin())
            x, y = viewport.place([road.x[point], road.y[point]]).tolist()
            yield text(str(road.edge), x, y, font_style="italic")
