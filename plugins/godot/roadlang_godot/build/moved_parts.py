"""What is built, moved by a map of the plane: roads and junctions while a network is dragged."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np

from roadlang.geometry import Floats

from ..net.protocol import Message
from ..net.scene_part import ScenePart
from .frame import SceneOrigin
from .road_mesh import SEGMENT_HEAD

PlaneMap = Callable[[Floats], Floats]
"""Where points (n, 2) of the world, in meters, come to lie."""
_COUNT = struct.Struct("<H")
_TRIANGLES_HEAD = 4


def moved_parts(parts: Sequence[ScenePart], frame: SceneOrigin, plane: PlaneMap) -> list[ScenePart]:
    """The parts with all strips of roads, patches and paint moved; what else there is stays.

    They are moved all at once: corners that parts share stay shared.
    """
    ranges = [_vertices(part) for part in parts]
    found = [part.body[first:last] for part, (first, last) in zip(parts, ranges, strict=True)]
    corners = np.frombuffer(b"".join(found), dtype="<f4").reshape(-1, 3)
    points = np.column_stack([corners[:, 0] + frame.x, frame.y - corners[:, 2]]).astype(float)
    moved = frame.ground(plane(points))
    moved[:, 1] = corners[:, 1]
    return list(_with_vertices(parts, ranges, moved.tobytes()))


def _with_vertices(
    parts: Iterable[ScenePart], ranges: Iterable[tuple[int, int]], vertices: bytes
) -> Iterable[ScenePart]:
    at = 0
    for part, (first, last) in zip(parts, ranges, strict=True):
        size = last - first
        own, at = vertices[at : at + size], at + size
        body = part.body[:first] + own + part.body[last:]
        yield replace(part, body=body, content=own + part.content[size:])


def _vertices(part: ScenePart) -> tuple[int, int]:
    """Where in its body the corners of a part are, (n, 3) f32; nowhere in what stays."""
    if part.kind == Message.SEGMENT:
        return SEGMENT_HEAD.size, len(part.body)
    if part.kind in (Message.PATCH, Message.PAINT):
        (count,) = _COUNT.unpack_from(part.body)
        return _TRIANGLES_HEAD, _TRIANGLES_HEAD + 12 * count
    return 0, 0
