"""Thinning of a mask to lines one pixel wide (Guo and Hall 1989), border pixels only."""

from __future__ import annotations

from functools import cache

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.fast_median import quantile

Pixels = NDArray[np.intp]
_BITS = np.arange(8, dtype=np.uint8)[:, None]


_GONE, _SET, _QUEUED = 0, 1, 3
"""States of a pixel: only the first is even."""


def skeleton(mask: Booleans) -> Booleans:
    """The skeleton (h, w) of a mask: same topology, one pixel wide, centered.

    The cost follows the length of the borders and the width of the shapes, not the image.
    """
    height, width = mask.shape
    stride = width + 2
    flat = np.zeros((height + 2) * stride, np.uint8)
    flat.reshape(height + 2, stride)[1:-1, 1:-1] = mask
    steps = [-stride, -stride + 1, 1, stride + 1, stride, stride - 1, -1, -stride - 1]
    around = np.array(steps)[:, None]
    places = np.empty(len(flat), np.int32)
    first, second = _tables()
    candidates = _border(flat, stride)
    while len(candidates):
        codes = _codes(flat, candidates, around)
        removable = candidates[first.take(codes)]
        flat[removable] = _GONE
        near = _queued(flat, removable, around, places)
        # All others have the neighbors that they had.
        same = flat.take(candidates) == _SET
        removable = np.concatenate([
            candidates[same][second.take(codes[same])],
            near[second.take(_codes(flat, near, around))],
        ])  # fmt: skip
        flat[removable] = _GONE
        candidates = np.concatenate([near, _queued(flat, removable, around, places)])
        candidates = candidates[flat.take(candidates) != _GONE]
        flat[candidates] = _SET
    return flat.reshape(height + 2, stride)[1:-1, 1:-1].astype(bool)


def widths_across(depths: NDArray[np.float32], shares: tuple[float, ...]) -> list[float]:
    """The widths, in pixels, that such shares of strokes are thinner than. `depths` (n,) of the
    pixels along their middles: how far the nearest pixel beside the stroke is. Half a pixel on
    each side of it is not of the stroke."""
    return [2 * quantile(depths, share) - 1 for share in shares]


def _codes(flat: NDArray[np.uint8], pixels: Pixels, around: Pixels) -> NDArray[np.uint8]:
    """Which neighbors of each pixel (n,) are set: bit 0 is north, clockwise."""
    is_set = flat.take(pixels + around)
    is_set &= 1
    is_set <<= _BITS
    return np.asarray(np.bitwise_or.reduce(is_set, axis=0))


def _queued(
    flat: NDArray[np.uint8], pixels: Pixels, around: Pixels, places: NDArray[np.int32]
) -> Pixels:
    """The neighbors of some pixels (n,) that are set and were not queued, each once; now they are,
    in place. `places`, as long as `flat`, is scratch memory."""
    beside = (pixels + around).ravel()
    beside = beside[flat.take(beside) == _SET]
    place = np.arange(len(beside), dtype=np.int32)
    places[beside] = place
    beside = beside[places.take(beside) == place]  # of the same pixel, one
    flat[beside] = _QUEUED
    return np.asarray(beside)


def _border(flat: NDArray[np.uint8], stride: int) -> Pixels:
    grid = flat.reshape(-1, stride)
    cross = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))
    inner = cv2.erode(grid, cross, borderType=cv2.BORDER_CONSTANT, borderValue=0)
    return np.flatnonzero((grid - inner).view(bool))


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
