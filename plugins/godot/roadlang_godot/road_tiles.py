"""Pixel roads: one tile per cell, whose shape follows from which of the four neighbors are road."""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

from .frame import SceneOrigin
from .protocol import BULK_DATAGRAM, HEADER_BYTES, Message
from .scene_part import ScenePart

NORTH, EAST, SOUTH, WEST = 1, 2, 4, 8

_HEAD = struct.Struct("<fffH")
_MOST = (BULK_DATAGRAM - HEADER_BYTES - 12 - _HEAD.size) // 5


def neighbor_masks(road: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """(rows, columns) bits of the neighbors that are road; row 0 is the northernmost."""
    padded = np.pad(road, 1)
    masks = (
        padded[:-2, 1:-1] * NORTH
        + padded[1:-1, 2:] * EAST
        + padded[2:, 1:-1] * SOUTH
        + padded[1:-1, :-2] * WEST
    )
    return np.asarray(masks, np.uint8)


def coarsened(road: NDArray[np.bool_], factor: int) -> NDArray[np.bool_]:
    """Blocks of `factor` by `factor` pixels as one cell each, road where half of it is.

    Blocks are counted from the bottom left, where the picture's origin is.
    """
    if factor <= 1:
        return road
    rows, columns = road.shape
    padded = np.pad(road, ((-rows % factor, 0), (0, -columns % factor)))
    blocks = padded.reshape(padded.shape[0] // factor, factor, padded.shape[1] // factor, factor)
    return np.asarray(blocks.mean(axis=(1, 3)) >= 0.5)


def tile_parts(
    road: NDArray[np.bool_],
    cell: float,
    origin: tuple[float, float],
    first_id: int,
    frame: SceneOrigin,
) -> list[ScenePart]:
    """Tiles of (rows, columns) cells of `cell` meters; `origin` is the bottom left corner."""
    masks = neighbor_masks(road)
    rows, columns = np.nonzero(road)
    shift = np.array([origin[0] - frame.x, frame.y - origin[1] - road.shape[0] * cell], "<f4")
    records = np.zeros(len(rows), dtype=[("x", "<i2"), ("z", "<i2"), ("mask", "u1")])
    records["x"], records["z"], records["mask"] = columns, rows, masks[rows, columns]
    parts = []
    # Square blocks of cells keep the rectangles of a merged collision body large.
    side = int(np.sqrt(_MOST))
    keys = rows // side * (columns.max(initial=0) // side + 1) + columns // side
    for index, key in enumerate(np.unique(keys)):
        block = records[keys == key]
        head = _HEAD.pack(cell, float(shift[0]), float(shift[1]), len(block))
        content = b"".join(sorted(record.tobytes() for record in block))
        label = f"tiles around column {block['x'][0]}, row {block['z'][0]}"
        parts.append(
            ScenePart(Message.TILES, first_id + index, head + block.tobytes(), content, label)
        )
    return parts
