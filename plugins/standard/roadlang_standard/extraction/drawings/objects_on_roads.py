"""What stands on a drawn road in a color of its own, such as a car: there is road beneath it."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..colors.tones import Layer
from ..masks.mask_parts import areas_of, parts_of, where_parts

_BESIDE = 0.5
"""Least share of an object's surroundings that is road."""
_THIN, _LEAST, _NARROW = 0.25, 4.0, 0.6
"""An object is at least `_THIN` widths of the road and `_LEAST` pixels thick (soft edges are
thinner), and at most `_NARROW` widths: an island may be as wide as the road."""
_USUAL = 0.7
"""Half the usual width is this quantile of the distances from the middle to the edge."""


def with_objects(surface: Layer, marked: Booleans) -> Layer:
    """The surface (h, w), 0..1, with the parts of what is `marked` (h, w) that stand on it."""
    mask = surface >= 0.5
    rest = (marked & ~mask).view(np.uint8)
    rest = cv2.morphologyEx(rest, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    count, parts = parts_of(rest > 0, 8)
    if count == 1 or not mask.any():
        return surface
    inner = cv2.distanceTransform(mask.view(np.uint8), cv2.DIST_L2, 5)
    ridge = inner[(inner >= cv2.dilate(inner, np.ones((3, 3)))) & mask]
    usual = 2 * float(np.quantile(ridge, _USUAL)) - 1
    rim = cv2.dilate(parts.astype(np.float32), np.ones((3, 3), np.uint8)).astype(np.int32)
    rim[parts > 0] = 0
    around = areas_of(rim, count)
    road = np.bincount(rim[mask], minlength=count)
    thick = np.zeros(count, np.float32)
    within = cv2.copyMakeBorder(rest, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0)
    depth = cv2.distanceTransform(within, cv2.DIST_L2, 5)[1:-1, 1:-1]
    there = np.flatnonzero(rest)
    np.maximum.at(thick, parts.ravel()[there], depth.ravel()[there])
    thick = 2 * thick - 1
    stands = (road > _BESIDE * around) & (thick < _NARROW * usual)
    stands &= thick >= max(_LEAST, _THIN * usual)
    stands[0] = False
    return np.where(where_parts(stands, parts), np.float32(1), surface) if stands.any() else surface
