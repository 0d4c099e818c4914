"""Sidewalks around the corners of junctions, from road to road."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import takewhile
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from roadlang.api import CURB_HEIGHT, CurbCorner, beside_curb, junction_curbs
from roadlang.geometry import CrossSection, Floats, Lane
from roadlang_standard.lane_looks import LaneLook

from ..net.scene_part import ScenePart
from .frame import SceneOrigin
from .lane_strips import LaneStrip, StripLine
from .road_mesh import strip_part

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneJunction

LOWERED = 0.03
"""Meters: the height at the corner, where people cross and long vehicles cut in."""
_RAMP = 1.5
"""Meters from there to the height of the sidewalks of the roads."""
_MOST_POINTS = 40
_LOOK = LaneStrip(0, 1, LaneLook.SIDEWALK, StripLine.CURB, StripLine.NONE, raised=True)


def sidewalk_parts(
    scene: Scene, junctions: Iterable[SceneJunction], first_id: int, frame: SceneOrigin
) -> list[ScenePart]:
    """A strip for each corner at which sidewalks of two roads end."""
    widths = {road.name: _raised_widths(road.cross_section()) for road in scene.roads}
    parts: list[ScenePart] = []
    for junction in junctions:
        for corner in junction_curbs(junction):
            ends = (
                widths[corner.first.road][corner.border],
                widths[corner.last.road][corner.next_border],
            )
            if min(ends) > 0.0:
                label = f"sidewalk at junction {junction.id}"
                strip, s = _strip(corner, ends, frame)
                parts.append(strip_part(label, strip, s, _LOOK, first_id + len(parts)))
    return parts


def _strip(
    corner: CurbCorner, ends: tuple[float, float], frame: SceneOrigin
) -> tuple[NDArray[np.float32], Floats]:
    """(n, 2, 3) its left and right border in the engine, and how far along they are."""
    curb = corner.curb[_thinned(len(corner.curb))]
    s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(curb, axis=0).T))])
    width = np.interp(s, (0.0, s[-1]), ends)
    strip = np.empty((len(s), 2, 3), dtype="<f4")
    strip[:, 0] = frame.ground(beside_curb(curb, width))
    strip[:, 1] = frame.ground(curb)
    from_end = np.minimum(s, s[-1] - s)
    strip[..., 1] = np.interp(from_end, (0.0, _RAMP), (CURB_HEIGHT, LOWERED))[:, None]
    return strip, np.linspace(0.0, float(s[-1]), len(s))


def _thinned(count: int) -> NDArray[np.int64]:
    return np.unique(np.linspace(0, count - 1, min(count, _MOST_POINTS)).round().astype(int))


def _raised_widths(section: CrossSection | None) -> tuple[float, float]:
    """Meters of raised lanes outside all others, at the left and at the right border."""
    if section is None:
        return (0.0, 0.0)
    return _outside(section.lanes), _outside(section.lanes[::-1])


def _outside(lanes: Iterable[Lane]) -> float:
    raised = takewhile(lambda lane: lane.raised, lanes)
    return float(sum(np.mean(lane.width.widths) for lane in raised))
