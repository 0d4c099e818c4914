"""Strokes of crayon and chalk: the grain of the paper shows through them as many small holes."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

_HOLE, _MANY, _OFTEN = 60, 12, 600
"""Holes have fewer pixels; strokes with at least so many of them, and one in so many pixels, have
grain. Letters have few, and what lies between streets is larger."""
_REACH = 4
"""Grain is closed, and burrs are removed, up to so many pixels to each side."""


def without_grain(marked: Booleans) -> Booleans:
    """The strokes (h, w), with the holes and burrs of those that have grain closed; itself if none
    has."""
    grainy = _grainy(marked)
    if grainy is None:
        return marked
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * _REACH + 1,) * 2)
    solid = cv2.morphologyEx(grainy.view(np.uint8), cv2.MORPH_CLOSE, kernel)
    opened = cv2.morphologyEx(solid, cv2.MORPH_OPEN, kernel)
    # Where the stroke is thinner than that, it stays.
    thin = (solid > 0) & (cv2.dilate(opened, kernel) == 0)
    return np.asarray((marked & ~grainy) | (opened > 0) | thin)


def _grainy(marked: Booleans) -> Booleans | None:
    """Those of the strokes (h, w) that have grain, None without any."""
    _, holes, stats, _ = cv2.connectedComponentsWithStats((~marked).view(np.uint8), connectivity=4)
    small = np.flatnonzero(stats[:, cv2.CC_STAT_AREA] < _HOLE)
    small = small[small > 0]
    if len(small) < _MANY:
        return None
    number, parts = cv2.connectedComponents(marked.view(np.uint8), connectivity=8)
    owners = parts.ravel()[_before(small, holes, stats)]
    found = np.bincount(owners, minlength=number)
    areas = np.bincount(parts.ravel(), minlength=number)
    grainy = (found >= _MANY) & (found * _OFTEN >= areas)
    grainy[0] = False
    return np.asarray(grainy[parts]) if grainy.any() else None


def _before(
    keys: NDArray[np.intp], holes: NDArray[np.int32], stats: NDArray[np.int32]
) -> NDArray[np.intp]:
    """The pixel, as an index of the flat picture, above the first one of each of some holes; at the
    border of the picture, that pixel itself."""
    tops, lefts = stats[keys, cv2.CC_STAT_TOP], stats[keys, cv2.CC_STAT_LEFT]
    widths = stats[keys, cv2.CC_STAT_WIDTH]
    columns = [
        left + int(np.argmax(holes[top, left : left + width] == key))
        for key, top, left, width in zip(keys, tops, lefts, widths, strict=True)
    ]
    return np.asarray(np.maximum(tops - 1, 0) * holes.shape[1] + columns, np.intp)
