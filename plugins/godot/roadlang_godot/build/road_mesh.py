"""Roads as strips of lanes, in pieces that each fit one datagram."""

from __future__ import annotations

import struct
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from roadlang.api import CURB_HEIGHT
from roadlang.geometry import DashPattern, Floats

from ..net.protocol import Message
from ..net.scene_part import BULK_BODY, ScenePart
from .frame import SceneOrigin
from .lane_strips import LaneStrip, lane_strips
from .line import RoadSamples
from .unfolded_border import unfolded

if TYPE_CHECKING:
    from roadlang.api import SurfaceName

PIECE = 100.0
"""Longest piece, meters: the unit of live edits."""
SAG = 0.01
"""How far a chord may be from the curve, meters."""
TURN = np.deg2rad(2.5)
"""By how much one chord may turn from the next, where more can be seen: in tight bends."""
COARSEST, FINEST = 2.5, 0.2
SHORTEST = 0.05
"""Meters of a stretch with a surface of its own, at least."""

_UNCUT = DashPattern()
SEGMENT_HEAD = struct.Struct("<BBBBBHff")
_MOST = (BULK_BODY - SEGMENT_HEAD.size) // 24


def stations(line: RoadSamples, start: float, end: float) -> Iterator[Floats]:
    """Arc lengths of the pieces between two stations, evenly spaced within each piece.

    Neighbors share their common station exactly, so that there is no gap.
    """
    at = start
    while end - at > 1e-6:
        length = min(PIECE, end - at)
        near = (line.s >= at - 1.0) & (line.s <= at + length + 1.0)
        bend = float(np.abs(line.curvature[near]).max(initial=0.0))
        bend = max(bend, 1e-9)
        spacing = min(float(np.sqrt(8 * SAG / bend)), TURN / bend)
        spacing = min(COARSEST, max(FINEST, spacing))
        count = int(np.ceil(length / spacing - 1e-9))
        if count + 1 > _MOST:
            count, length = _MOST - 1, (_MOST - 1) * spacing
        # A last piece too short to see is added to the one before it.
        if end - (at + length) < 0.5 * spacing:
            length = end - at
        yield np.linspace(at, at + length, max(count, 1) + 1)
        at = float(at + length)


def segments(
    line: RoadSamples,
    s: Floats,
    strips: Sequence[LaneStrip],
    first_id: int,
    frame: SceneOrigin,
    dashes: DashPattern = _UNCUT,
) -> list[ScenePart]:
    """The piece of a road with these stations: a thing for each strip of lanes."""
    edges = line.beside(s, line.cross_section.border_offsets(s))
    ahead = line.at(0.5 * (s[:-1] + s[1:]))[1]
    edges = np.stack([unfolded(border, ahead) for border in edges])
    parts = []
    for id, look in enumerate(strips, start=first_id):
        strip = np.empty((len(s), 2, 3), dtype="<f4")
        strip[:, 0] = frame.ground(edges[look.first])
        strip[:, 1] = frame.ground(edges[look.last])
        strip[..., 1] += CURB_HEIGHT if look.raised else 0.0
        parts.append(strip_part(line.name, strip, s, look, id, dashes))
    return parts


def strip_part(
    name: str,
    strip: NDArray[np.float32],
    s: Floats,
    look: LaneStrip,
    id: int,
    dashes: DashPattern = _UNCUT,
) -> ScenePart:
    """A segment of (n, 2, 3) left and right edge points in engine coordinates."""
    first, second = dashes.at(float(s[0])), dashes.at(float(s[1]))
    vertices = strip.tobytes()
    marks = (look.surface | look.material << 4, look.left, look.right, int(look.raised))
    head = SEGMENT_HEAD.pack(min(look.lanes, 255), *marks, len(s), first, second - first)
    label = f"{name} from {s[0]:.0f} m to {s[-1]:.0f} m"
    return ScenePart(Message.SEGMENT, id, head + vertices, vertices, label)


def road_parts(
    line: RoadSamples,
    first_id: int,
    frame: SceneOrigin,
    start: float | None = None,
    end: float | None = None,
) -> list[ScenePart]:
    """All pieces of a road, or of the part of it between two stations."""
    begin = float(line.s[0]) if start is None else start
    finish = float(line.s[-1]) if end is None else end
    parts: list[ScenePart] = []
    dashes = DashPattern.between(begin, finish, (float(line.s[0]), float(line.s[-1])))
    for low, high, surfaces in _stretches(line, begin, finish):
        strips = tuple(lane_strips(line.cross_section, surfaces))
        for s in stations(line, low, high):
            parts += segments(line, s, strips, first_id + len(parts), frame, dashes)
    return parts


def _stretches(
    line: RoadSamples, begin: float, finish: float
) -> Iterator[tuple[float, float, tuple[SurfaceName | None, ...]]]:
    """Where on a part of a road which surfaces are: from, to, of the lanes from left to right."""
    if not line.stretches:
        yield begin, finish, ()
        return
    inner = [stretch.end for stretch in line.stretches[:-1]]
    cuts = [begin, *(end for end in inner if begin + SHORTEST < end < finish - SHORTEST), finish]
    for low, high in pairwise(cuts):
        middle = 0.5 * (low + high)
        yield low, high, line.stretches[bisect_left(inner, middle)].surfaces
