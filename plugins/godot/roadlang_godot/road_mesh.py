"""Roads as strips between their edges, in pieces that each fit one datagram."""

from __future__ import annotations

import struct
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from .frame import SceneOrigin
from .line import RoadSamples
from .protocol import BULK_DATAGRAM, HEADER_BYTES, Message
from .thing import ScenePart

SURFACE_MARKED, SURFACE_PLAIN = 0, 1
PIECE = 100.0
"""Longest piece, meters: the unit of live edits."""
SAG = 0.01
"""How far a chord may be from the curve, meters."""
COARSEST, FINEST = 2.5, 0.4

_HEAD = struct.Struct("<BBHff")
_MOST = (BULK_DATAGRAM - HEADER_BYTES - 12 - _HEAD.size) // 24


def stations(line: RoadSamples, start: float, end: float) -> Iterator[Floats]:
    """Arc lengths of the pieces between two stations, evenly spaced within each piece.

    Neighbors share their common station exactly, so that there is no gap.
    """
    at = start
    while end - at > 1e-6:
        length = min(PIECE, end - at)
        near = (line.s >= at - 1.0) & (line.s <= at + length + 1.0)
        bend = float(np.abs(line.curvature[near]).max(initial=0.0))
        spacing = min(COARSEST, max(FINEST, float(np.sqrt(8 * SAG / max(bend, 1e-9)))))
        count = int(np.ceil(length / spacing - 1e-9))
        if count + 1 > _MOST:
            count, length = _MOST - 1, (_MOST - 1) * spacing
        # A last piece too short to see is added to the one before it.
        if end - (at + length) < 0.5 * spacing:
            length = end - at
        yield np.linspace(at, at + length, max(count, 1) + 1)
        at = float(at + length)


def segment(
    line: RoadSamples, s: Floats, id: int, frame: SceneOrigin, surface: int = SURFACE_MARKED
) -> ScenePart:
    """The piece of a road with these stations."""
    left, right = line.edges(s)
    strip = np.empty((len(s), 2, 3), dtype="<f4")
    strip[:, 0] = frame.ground(left)
    strip[:, 1] = frame.ground(right)
    return strip_thing(line.name, strip, s, line.lanes, id, surface)


def strip_thing(
    name: str, strip: NDArray[np.float32], s: Floats, lanes: int, id: int, surface: int
) -> ScenePart:
    """A segment of (n, 2, 3) left and right edge points in engine coordinates."""
    spacing = float(s[1] - s[0])
    vertices = strip.tobytes()
    head = _HEAD.pack(min(max(lanes, 1), 255), surface, len(s), float(s[0]), spacing)
    label = f"{name} from {s[0]:.0f} m to {s[-1]:.0f} m"
    return ScenePart(Message.SEGMENT, id, head + vertices, vertices, label)


def road_things(
    line: RoadSamples,
    first_id: int,
    frame: SceneOrigin,
    start: float | None = None,
    end: float | None = None,
) -> list[ScenePart]:
    """All pieces of a road, or of the part of it between two stations."""
    begin = float(line.s[0]) if start is None else start
    finish = float(line.s[-1]) if end is None else end
    pieces = stations(line, begin, finish)
    return [segment(line, s, first_id + i, frame) for i, s in enumerate(pieces)]
