"""Pixel roads: one tile per cell, whose shape follows from which of the four neighbors are road."""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

from roadlang_standard.extraction.legends.cell_links import joined_at_corners

from ..net.protocol import Message
from ..net.scene_part import BULK_BODY, ScenePart
from .frame import SceneOrigin

NORTH, EAST, SOUTH, WEST = 1, 2, 4, 8
NORTH_EAST, SOUTH_EAST, SOUTH_WEST, NORTH_WEST = 16, 32, 64, 128

_HEAD = struct.Struct("<fffH")
_MOST = (BULK_BODY - _HEAD.size) // 5


def neighbor_masks(road: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """(rows, columns) bits of the neighbors that are road; row 0 is the northernmost.

    A diagonal one counts where both sides between are road too: all four are one wide road.
    """
    padded = np.pad(road, 1)
    north, south = padded[:-2, 1:-1], padded[2:, 1:-1]
    east, west = padded[1:-1, 2:], padded[1:-1, :-2]
    masks = north * NORTH + east * EAST + south * SOUTH + west * WEST
    masks = masks + (north & east & padded[:-2, 2:]) * NORTH_EAST
    masks = masks + (south & east & padded[2:, 2:]) * SOUTH_EAST
    masks = masks + (south & west & padded[2:, :-2]) * SOUTH_WEST
    masks = masks + (north & west & padded[:-2, :-2]) * NORTH_WEST
    return np.asarray(masks, np.uint8)


def with_corners_joined(road: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Cells that touch by their corners alone get a cell beside them that joins them by sides.

    Roads and networks join such cells too. Of the two cells beside them the one with fewer road
    neighbors is filled, else the one in the upper row.
    """
    filled = road.copy()
    rows, columns = np.nonzero(joined_at_corners(road).any(axis=-1))
    sides = (neighbor_masks(road)[..., None] >> np.arange(4) & 1).sum(axis=-1)
    for row, column in zip(rows.tolist(), columns.tolist(), strict=True):
        upper = (row, column + int(road[row, column]))
        lower = (row + 1, column + int(road[row + 1, column]))
        if not (filled[upper] or filled[lower]):
            filled[min(upper, lower, key=lambda cell: int(sides[cell]))] = True
    return filled


def coarsened(road: NDArray[np.bool_], factor: int) -> NDArray[np.bool_]:
    """Blocks of `factor` by `factor` pixels as one cell each, road where half of it is. Of roads
    that are thinner than a block, every block that they pass is road.

    Blocks are counted from the bottom left, where the picture's origin is.
    """
    if factor <= 1:
        return road
    cells = _blocks(road, factor).mean(axis=(1, 3)) >= 0.5
    return np.asarray(cells | _blocks(_thin(road, factor), factor).any(axis=(1, 3)))


def _blocks(pixels: NDArray[np.bool_], factor: int) -> NDArray[np.bool_]:
    """(rows, factor, columns, factor)."""
    rows, columns = pixels.shape
    padded = np.pad(pixels, ((-rows % factor, 0), (0, -columns % factor)))
    return padded.reshape(padded.shape[0] // factor, factor, padded.shape[1] // factor, factor)


def _thin(road: NDArray[np.bool_], factor: int) -> NDArray[np.bool_]:
    """The pixels of roads into which no block fits: what opening by a block removes, but for the
    bumps of wider roads."""
    import cv2

    block = np.ones((factor, factor), np.uint8)
    opened = cv2.morphologyEx(road.astype(np.uint8), cv2.MORPH_OPEN, block)
    beyond = cv2.dilate(opened, np.ones((2 * factor + 1,) * 2, np.uint8)) == 0
    count, parts = cv2.connectedComponents((road & (opened == 0)).astype(np.uint8), connectivity=8)
    roads = np.zeros(count, dtype=bool)
    roads[parts[road & beyond]] = True
    roads[0] = False
    return np.asarray(roads[parts])


def tile_parts(
    road: NDArray[np.bool_],
    cell: float,
    origin: tuple[float, float],
    first_id: int,
    frame: SceneOrigin,
    surfaces: NDArray[np.int64] | None = None,
) -> list[ScenePart]:
    """Tiles of (rows, columns) cells of `cell` meters; `origin` is the bottom left corner;
    `surfaces` (rows, columns): the numbers of their surfaces, where any is said."""
    masks = neighbor_masks(road)
    rows, columns = np.nonzero(road)
    shift = np.array([origin[0] - frame.x, frame.y - origin[1] - road.shape[0] * cell], "<f4")
    records = np.zeros(len(rows), dtype=[("x", "<i2"), ("z", "<i2"), ("mask", "u1")])
    records["x"], records["z"], records["mask"] = columns, rows, masks[rows, columns]
    parts = []
    # Square blocks of cells keep the rectangles of a merged collision body large.
    side = int(np.sqrt(_MOST))
    keys = rows // side * (columns.max(initial=0) // side + 1) + columns // side
    made_of = np.zeros_like(rows) if surfaces is None else surfaces[rows, columns]
    keys = keys * (1 + int(made_of.max(initial=0))) + made_of
    for index, key in enumerate(np.unique(keys)):
        block = records[keys == key]
        surface = int(made_of[keys == key][0])
        last = bytes([surface]) if surface else b""
        head = _HEAD.pack(cell, float(shift[0]), float(shift[1]), len(block))
        content = b"".join(sorted(record.tobytes() for record in block))
        label = f"tiles around column {block['x'][0]}, row {block['z'][0]}"
        parts.append(
            ScenePart(
                Message.TILES, first_id + index, head + block.tobytes() + last, content, label
            )
        )
    return parts
