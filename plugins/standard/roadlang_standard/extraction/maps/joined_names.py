"""Names of a map that touch one another: each of the straight lines of letters by itself."""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Image
from ..masks.mask_parts import parts_and_boxes

_LENGTH, _DIRECTIONS, _MOST = 41, 16, 4
"""A line of letters contains a straight line of `_LENGTH` pixels in one of `_DIRECTIONS`. At most
`_MOST` lines are sought in letters that touch."""
_MARGIN = 3
"""Where two lines of letters meet, pixels this near to one of them are not part of the other."""


def lines_of_letters(points: NDArray[np.float64]) -> Iterator[NDArray[np.float64]]:
    """The pixels (m, 2) of each straight line of letters among the pixels (n, 2) of several names
    that touch, the longest first."""
    if not len(points):
        return
    corner = points.min(axis=0) - _LENGTH // 2
    column, row = (points - corner).astype(np.intp).T
    left = np.zeros((row.max() + 1 + _LENGTH // 2, column.max() + 1 + _LENGTH // 2), np.uint8)
    left[row, column] = 1
    for _ in range(_MOST):
        line = _longest(left)
        if line is None:
            return
        y, x = np.nonzero(line)
        yield np.stack([x, y], axis=1).astype(np.float64) + corner
        size = 2 * _MARGIN + 1
        left &= 1 - cv2.dilate(line.view(np.uint8), np.ones((size, size), np.uint8))


def _longest(letters: Image) -> Booleans | None:
    """The line of letters (h, w) with most pixels in any direction; None if there is none."""
    best, most = None, 0
    for step in range(_DIRECTIONS):
        opened = cv2.morphologyEx(letters, cv2.MORPH_OPEN, _stroke(np.pi * step / _DIRECTIONS))
        _, parts, stats = parts_and_boxes(opened > 0)
        areas = stats[1:, cv2.CC_STAT_AREA]
        if areas.size and areas.max() > most:
            most = int(areas.max())
            best = parts == 1 + int(areas.argmax())
    return best


def _stroke(angle: float) -> Image:
    """A straight line of `_LENGTH` pixels at an angle (rad), as a kernel."""
    half = _LENGTH // 2
    kernel = np.zeros((_LENGTH, _LENGTH), np.uint8)
    x, y = round(half * np.cos(angle)), round(half * np.sin(angle))
    cv2.line(kernel, (half - x, half - y), (half + x, half + y), 1)
    return kernel
