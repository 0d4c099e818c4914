"""The connected parts of a mask."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans, Floats

_SAMPLED, _MANY = 101, 0.1
"""Large parts are found by looking at one pixel in `_SAMPLED`. A list of more than `_MANY` of all
pixels takes more time and memory than counting all of them."""


def parts_of(mask: Booleans, connectivity: int = 4) -> tuple[int, NDArray[np.int32]]:
    """How many labels there are, and the label (h, w) of each pixel, 0 where the mask is not set.

    Without diagonals OpenCV's usual algorithm takes twice as long as this one (Bolelli et al.
    2019), which numbers the parts alike.
    """
    seen = mask.view(np.uint8)
    if connectivity == 8:
        count, labels = cv2.connectedComponents(seen, connectivity=8)
    else:
        count, labels = cv2.connectedComponentsWithAlgorithm(seen, 4, cv2.CV_32S, cv2.CCL_BOLELLI)
    return count, np.asarray(labels, np.int32)


def small_parts(mask: Booleans, most: float, connectivity: int = 4) -> Booleans | None:
    """The parts (h, w) of a mask of fewer than `most` pixels; None if there are none.

    A few pixels tell which parts are large for sure: those of the others alone are counted.
    """
    count, labels = parts_of(mask, connectivity)
    flat = labels.ravel()
    doubtful = np.bincount(flat[::_SAMPLED], minlength=count) < most
    doubtful[0] = False
    if not doubtful.any():
        return None
    found = np.asarray(doubtful.take(labels))
    if np.count_nonzero(found) > _MANY * found.size:
        doubtful &= np.bincount(flat, minlength=count) < most
        return np.asarray(doubtful.take(labels)) if doubtful.any() else None
    pixels = np.flatnonzero(found)
    owner = flat[pixels]
    large = np.bincount(owner, minlength=count)[owner] >= most
    if large.all():
        return None
    found.ravel()[pixels[large]] = False
    return found


def window_around(mask: Booleans | NDArray[np.uint8], margin: int) -> tuple[slice, slice]:
    """The rows and columns of a picture that hold a mask (h, w) and so many pixels around it.

    They begin at even numbers: OpenCV numbers parts by squares of 2 x 2 pixels, here as in all of
    the picture.
    """
    x, y, width, height = cv2.boundingRect(mask.view(np.uint8))
    rows = slice(max(0, y - margin) & ~1, y + height + margin)
    return rows, slice(max(0, x - margin) & ~1, x + width + margin)


def parts_touching(mask: Booleans, reach: Booleans) -> Booleans:
    """The connected parts of a mask (h, w) that meet another one (h, w)."""
    count, parts = cv2.connectedComponents(mask.astype(np.uint8), connectivity=8)
    met = np.bincount(parts[reach], minlength=count) > 0
    met[0] = False
    return np.asarray(met[parts])


def is_inside(mask: Booleans, place: Floats) -> bool:
    """Whether a place (2,) is on a mask (h, w)."""
    x, y = np.round(place).astype(int)
    return bool(0 <= x < mask.shape[1] and 0 <= y < mask.shape[0] and mask[y, x])
