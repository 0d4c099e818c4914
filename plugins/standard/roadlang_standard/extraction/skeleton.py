"""Thinning of a mask to lines one pixel wide (Guo and Hall 1989), border pixels only."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans


def skeleton(mask: Booleans) -> Booleans:
    """The skeleton (h, w) of a mask: same topology, one pixel wide, centered.

    The cost follows the length of the borders and the width of the shapes, not the image.
    """
    height, width = mask.shape
    stride = width + 2
    flat = np.zeros((height + 2) * stride, np.uint8)
    flat.reshape(height + 2, stride)[1:-1, 1:-1] = mask
    around = np.array([-stride, -stride + 1, 1, stride + 1, stride, stride - 1, -1, -stride - 1])
    stamp = np.zeros(flat.shape, np.int32)
    candidates = _border(flat, stride)
    while len(candidates):
        near = []
        for table in _tables():
            codes = np.zeros(len(candidates), np.uint8)
            for bit, step in enumerate(around):
                codes |= flat.take(candidates + step) << np.uint8(bit)
            removable = candidates[table.take(codes)]
            flat[removable] = 0
            near.append((removable[:, None] + around).ravel())
            candidates = _alive(flat, stamp, np.concatenate([candidates, near[-1]]))
        candidates = _alive(flat, stamp, np.concatenate(near))
    return flat.reshape(height + 2, stride)[1:-1, 1:-1].astype(bool)


def _border(flat: NDArray[np.uint8], stride: int) -> NDArray[np.intp]:
    grid = flat.reshape(-1, stride)
    inner = grid[1:-1, 1:-1] & grid[:-2, 1:-1] & grid[2:, 1:-1] & grid[1:-1, :-2] & grid[1:-1, 2:]
    edge = grid.copy()
    edge[1:-1, 1:-1] -= inner
    return np.flatnonzero(edge.view(bool))


def _alive(
    flat: NDArray[np.uint8], stamp: NDArray[np.int32], pixels: NDArray[np.intp]
) -> NDArray[np.intp]:
    """Those of the pixels that are still set, each once."""
    pixels = pixels[flat.take(pixels) > 0]
    order = np.arange(len(pixels), dtype=np.int32)
    stamp[pixels] = order
    return np.asarray(pixels[stamp.take(pixels) == order])


@cache
def _tables() -> tuple[Booleans, Booleans]:
    """For both half steps: may a pixel with these neighbors go? Bit 0 is north, clockwise."""
    code = np.arange(256)
    p2, p3, p4, p5, p6, p7, p8, p9 = ((code >> bit) & 1 for bit in range(8))
    crossings = ((1 - p2) & (p3 | p4)) + ((1 - p4) & (p5 | p6))
    crossings = crossings + ((1 - p6) & (p7 | p8)) + ((1 - p8) & (p9 | p2))
    first = (p9 | p2) + (p3 | p4) + (p5 | p6) + (p7 | p8)
    second = (p2 | p3) + (p4 | p5) + (p6 | p7) + (p8 | p9)
    count = np.minimum(first, second)
    simple = (crossings == 1) & (count >= 2) & (count <= 3)
    even = ((p6 | p7 | (1 - p9)) & p8) == 0
    odd = ((p2 | p3 | (1 - p5)) & p4) == 0
    return simple & even, simple & odd
