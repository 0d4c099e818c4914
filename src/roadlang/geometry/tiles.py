"""Tiles of a grid of cells: which neighbors each has, and the shape that follows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import GeometryError

NORTH, EAST, SOUTH, WEST = 1, 2, 4, 8


@dataclass(frozen=True, slots=True)
class TileShape:
    """`name`: dot, end, straight, corner, tee or cross; `turns`: quarter turns clockwise."""

    name: str
    turns: int

    @property
    def mask(self) -> int:
        """The neighbor mask that this shape is for."""
        return _SHAPES.index(self)


_FAMILIES = {
    "dot": (0,),
    "end": (1, 2, 4, 8),
    "straight": (5, 10),
    "corner": (3, 6, 12, 9),
    "tee": (7, 14, 13, 11),
    "cross": (15,),
}
_BY_MASK = {
    mask: TileShape(name, turns)
    for name, masks in _FAMILIES.items()
    for turns, mask in enumerate(masks)
}
_SHAPES = tuple(_BY_MASK[mask] for mask in range(16))


def neighbor_mask(cells: ArrayLike) -> NDArray[np.uint8]:
    """For each set cell of a Boolean grid (rows from north to south), the sum of N 1, E 2, S 4,
    W 8 over its set neighbors; 0 for cells that are not set (and for those that stand alone)."""
    grid = np.asarray(cells, dtype=bool)
    if grid.ndim != 2:
        raise GeometryError("a grid of tiles has two dimensions")
    around = np.pad(grid, 1)
    mask = (
        NORTH * around[:-2, 1:-1].astype(np.uint8)
        + EAST * around[1:-1, 2:].astype(np.uint8)
        + SOUTH * around[2:, 1:-1].astype(np.uint8)
        + WEST * around[1:-1, :-2].astype(np.uint8)
    )
    return np.where(grid, mask, 0).astype(np.uint8)


def tile_shape(mask: int) -> TileShape:
    """The shape of a tile with this neighbor mask."""
    if not 0 <= mask < 16:
        raise GeometryError("a neighbor mask is a number from 0 to 15")
    return _SHAPES[mask]


def tile_shapes(cells: ArrayLike) -> dict[tuple[int, int], TileShape]:
    """The shape of each set cell of a Boolean grid, by (row, column)."""
    grid = np.asarray(cells, dtype=bool)
    masks = neighbor_mask(grid)
    return {
        (int(row), int(column)): _SHAPES[int(masks[row, column])]
        for row, column in np.argwhere(grid)
    }
