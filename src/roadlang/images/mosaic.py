"""Pictures that lie beside each other on Earth, put together to one."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from .border_color import border_color
from .georeference import Georeference
from .image_scale import FoundScale

Pixels = NDArray[np.uint8]

_SAME_SIZE = 0.01
"""Share by which the pixels of two tiles may differ in size."""
_LEAST_TURN = 0.5
"""Pixels over a tile by which it may be turned against the first before it is drawn anew."""


class TilesDoNotFit(Exception):
    """Why pictures cannot be put together."""


@dataclass(frozen=True, eq=False)
class Tile:
    """`pixels` (height, width, 3) of the file `name`, and what it says of its size and place;
    `shown` (height, width) where it shows something, None: everywhere."""

    name: str
    pixels: Pixels
    found: FoundScale
    shown: NDArray[np.bool_] | None = None

    @property
    def reference(self) -> Georeference:
        """Its place. Raises TilesDoNotFit where there is none."""
        found = self.found.reference
        if found is None or not np.linalg.det(np.reshape(found.matrix, (2, 3))[:, :2]):
            raise TilesDoNotFit(f"`{self.name}` is not georeferenced")
        return found

    @property
    def matrix(self) -> NDArray[np.float64]:
        """(3, 3), from corners of pixels, columns and rows, to coordinates of its grid."""
        return np.array([*self.reference.matrix, 0.0, 0.0, 1.0]).reshape(3, 3)


def mosaic(tiles: Sequence[Tile], most_pixels: int) -> tuple[Pixels, FoundScale]:
    """One picture in the pixels of the first tile; what a later tile shows covers an earlier one.

    What no tile shows has the usual color of their borders. Raises TilesDoNotFit, also where the
    picture would have more than `most_pixels`.
    """
    first = tiles[0]
    for tile in tiles:
        _check(tile, first)
    to_first = np.linalg.inv(first.matrix)
    placements = [to_first @ tile.matrix for tile in tiles]
    corners = np.concatenate([_corners(*pair) for pair in zip(tiles, placements, strict=True)])
    # A hair of a pixel is rounding of coordinates, not a further column.
    low, high = np.floor(corners.min(axis=0) + 0.01), np.ceil(corners.max(axis=0) - 0.01)
    if not float(np.prod(high - low)) <= most_pixels:
        most = f"and at most {most_pixels // 1_000_000} million pixels can be read"
        raise TilesDoNotFit(f"they span {high[0] - low[0]:.0f} x {high[1] - low[1]:.0f} px, {most}")
    width, height = (int(side) for side in high - low)
    canvas = np.empty((height, width, 3), np.uint8)
    canvas[:] = border_color([tile.pixels for tile in tiles], [tile.shown for tile in tiles])
    shift = np.array([[1.0, 0.0, -low[0]], [0.0, 1.0, -low[1]], [0.0, 0.0, 1.0]])
    for tile, placement in zip(tiles, placements, strict=True):
        _paste(canvas, tile, shift @ placement)
    a, b, c, d, e, f = (first.matrix @ np.linalg.inv(shift))[:2].ravel().tolist()
    reference = replace(first.reference, matrix=(a, b, c, d, e, f))
    return canvas, FoundScale(first.found.meters, reference)


def _check(tile: Tile, first: Tile) -> None:
    if tile.reference.grid != first.reference.grid:
        raise TilesDoNotFit(f"`{tile.name}` and `{first.name}` use different coordinate systems")
    own, other = (math.sqrt(abs(np.linalg.det(each.matrix[:2, :2]))) for each in (tile, first))
    if not abs(own - other) <= _SAME_SIZE * other:
        raise TilesDoNotFit(f"the pixels of `{tile.name}` and `{first.name}` differ in size")


def _corners(tile: Tile, placement: NDArray[np.float64]) -> NDArray[np.float64]:
    """(4, 2), after `placement` (3, 3)."""
    height, width = tile.pixels.shape[:2]
    places = np.array([(x, y, 1.0) for x in (0.0, width) for y in (0.0, height)])
    return np.asarray(places @ placement[:2].T)


def _paste(canvas: Pixels, tile: Tile, placement: NDArray[np.float64]) -> None:
    height, width = tile.pixels.shape[:2]
    off = (placement[:2, :2] - np.eye(2)) * (width, height)
    if np.abs(off).sum() < _LEAST_TURN:
        column, row = (round(float(value)) for value in placement[:2, 2])
        row = min(max(row, 0), len(canvas) - height)
        column = min(max(column, 0), canvas.shape[1] - width)
        part = canvas[row : row + height, column : column + width]
        _copy(part, tile.pixels, tile.shown)
        return
    # From middles of pixels to middles of pixels.
    half = np.array([[1.0, 0.0, 0.5], [0.0, 1.0, 0.5], [0.0, 0.0, 1.0]])
    matrix = (np.linalg.inv(half) @ placement @ half)[:2]
    size = (canvas.shape[1], len(canvas))
    drawn = canvas if tile.shown is None else canvas.copy()
    cv2.warpAffine(
        tile.pixels, matrix, size, dst=drawn,
        flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_TRANSPARENT,
    )  # fmt: skip
    if tile.shown is not None:
        shown = cv2.warpAffine(tile.shown.astype(np.uint8), matrix, size, flags=cv2.INTER_NEAREST)
        _copy(canvas, drawn, shown > 0)


def _copy(canvas: Pixels, pixels: Pixels, shown: NDArray[np.bool_] | None) -> None:
    if shown is None:
        canvas[:] = pixels
    else:
        canvas[shown] = pixels[shown]
