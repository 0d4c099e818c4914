"""Masks grown, closed and opened by ellipses: the same as OpenCV's.

Row by row of the ellipse, instead of pixel by pixel, this takes a tenth of the time for large ones.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

_LARGE = 15
"""Ellipses of fewer pixels are left to OpenCV."""
_TOGETHER = 1 << 18
"""Number of pixels that are looked at together: more do not stay in a processor's cache."""


def grown_by(mask: Booleans, size: int) -> Booleans:
    """The mask (h, w) dilated by an ellipse `size` pixels wide and high."""
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    if size < _LARGE:
        return np.asarray(cv2.dilate(mask.view(np.uint8), kernel) > 0)
    height, width = mask.shape
    stride, before = width + size - 1, size // 2
    result = np.empty(mask.shape, bool)
    rows = max(2 * size, _TOGETHER // stride)
    for top in range(0, height, rows):
        bottom = min(height, top + rows)
        first, last = max(0, top - before), min(height, bottom + size - 1 - before)
        around = np.zeros((bottom - top + size, stride), bool)  # a row more than is needed
        place = first - (top - before)
        around[place : place + last - first, before : before + width] = mask[first:last]
        found = _reached(around.ravel(), (bottom - top) * stride, stride, kernel)
        result[top:bottom] = found.reshape(-1, stride)[:, :width]
    return result


def closed_by(mask: Booleans, size: int) -> Booleans:
    """The mask (h, w) closed by an ellipse `size` pixels wide and high."""
    if size < _LARGE:
        kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
        return np.asarray(cv2.morphologyEx(mask.view(np.uint8), cv2.MORPH_CLOSE, kernel) > 0)
    return ~grown_by(~grown_by(mask, size), size)


def opened_by(mask: Booleans, size: int) -> Booleans:
    """The mask (h, w) opened by an ellipse `size` pixels wide and high."""
    if size < _LARGE:
        kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
        return np.asarray(cv2.morphologyEx(mask.view(np.uint8), cv2.MORPH_OPEN, kernel) > 0)
    return grown_by(~grown_by(~mask, size), size)


def _reached(flat: Booleans, count: int, stride: int, kernel: NDArray[np.uint8]) -> Booleans:
    """Which of the first pixels (count,) of rows of so many have one that is set below the kernel
    when its upper left corner is there."""
    begins, lengths = kernel.argmax(axis=1), np.count_nonzero(kernel, axis=1)
    found = np.zeros(count, bool)
    run, length = flat.copy(), 1  # whether any of so many pixels from here on is set
    for wanted in np.unique(lengths).tolist():
        while length < wanted:
            step = min(length, wanted - length)
            run[:-step] |= run[step:].copy()
            length += step
        for row in np.flatnonzero(lengths == wanted).tolist():
            start = row * stride + int(begins[row])
            found |= run[start : start + count]
    return found
