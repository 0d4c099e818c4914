"""What stands and is painted at junctions: stop lines, arrows, zebra crossings, signals."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from roadlang.api import (
    PAINT_HEIGHT,
    crosswalk_paint,
    junction_paint,
    paint_rings,
    signal_heads,
)
from roadlang.geometry import Floats

from ..net.protocol import Message
from ..net.scene_part import BULK_BODY, ScenePart
from .frame import SceneOrigin
from .junctions import triangles_part

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneJunction

_LARGEST = BULK_BODY - 4
_CORNER_BYTES, _TRIANGLE_BYTES = 12, 6


def paint_parts(
    scene: Scene, junctions: Sequence[SceneJunction], frame: SceneOrigin
) -> list[ScenePart]:
    """The paint of all junctions and crosswalks, as much in one thing as a datagram holds."""
    parts: list[ScenePart] = []
    batch: list[Floats] = []
    for ring in paint_rings((*junction_paint(scene, junctions), *crosswalk_paint(scene))):
        if batch and sum(map(_size, (*batch, ring))) > _LARGEST:
            parts.append(_paint(batch, len(parts) + 1, frame))
            batch = []
        batch.append(ring)
    return [*parts, _paint(batch, len(parts) + 1, frame)] if batch else parts


def signal_parts(junctions: Iterable[SceneJunction], frame: SceneOrigin) -> list[ScenePart]:
    """The signals of each junction that has some."""
    parts: list[ScenePart] = []
    for junction in junctions:
        heads, control = list(signal_heads(junction)), junction.control
        if not heads:
            continue
        places = np.empty((len(heads), 4), dtype="<f4")
        places[:, :3] = frame.ground(np.array([[head.x, head.y] for head in heads]))
        places[:, 3] = [head.heading for head in heads]
        seconds = np.array([(p.green, p.yellow, p.all_red) for p in control.phases], dtype="<f4")
        green = bytes(
            head.connections[0] in phase.connections for head in heads for phase in control.phases
        )
        elapsed = control.offset % control.cycle
        head = struct.pack("<BBf", len(heads), len(control.phases), elapsed)
        body = head + seconds.tobytes() + places.tobytes() + green
        content = places[:, :3].tobytes() + seconds.tobytes() + green
        label = f"signals of junction {junction.id}"
        parts.append(ScenePart(Message.SIGNALS, len(parts) + 1, body, content, label))
    return parts


def _size(ring: Floats) -> int:
    return len(ring) * _CORNER_BYTES + (len(ring) - 2) * _TRIANGLE_BYTES


def _paint(rings: Sequence[Floats], id: int, frame: SceneOrigin) -> ScenePart:
    corners = frame.ground(np.concatenate(rings), PAINT_HEIGHT)
    fans: list[NDArray[np.int64]] = []
    first = 0
    for ring in rings:
        last = np.arange(first + 2, first + len(ring))
        # Clockwise seen from above, which is the front in the engine.
        fans.append(np.stack([np.full(len(last), first), last, last - 1], axis=-1))
        first += len(ring)
    return triangles_part(Message.PAINT, corners, np.concatenate(fans), id, f"paint {id}")
