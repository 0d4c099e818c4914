"""Lines painted on a drawn road, such as dashes along its middle: they are road as well."""

from __future__ import annotations

import cv2
import numpy as np
from scipy.ndimage import maximum

from .mask_parts import parts_of
from .tones import Layer

_THIN = 5.0
"""A marking has at least so many times its thickness of road around it, ..."""
_SHORT = 2.5
"""and is at most so many widths of the road long: a longer one is a median, ..."""
_LINE = 10.0
"""unless it is so many times as thin."""
_LARGEST = 0.02
"""No part that is more of the picture is a marking."""


def with_markings_filled(surface: Layer) -> Layer:
    """The surface (h, w), 0..1, with thin short gaps within its roads filled; itself if there are
    none."""
    mask = (surface >= 0.5).astype(np.uint8)
    count, labels = parts_of(mask == 0)
    areas = np.bincount(labels.ravel(), minlength=count)
    keys = np.flatnonzero(areas < _LARGEST * mask.size)
    keys = keys[keys > 0]
    if not len(keys):
        return surface
    small = np.isin(np.arange(len(areas)), keys).take(labels)
    gap = cv2.distanceTransform(1 - mask, cv2.DIST_L2, 5)
    road = cv2.distanceTransform(mask | small.view(np.uint8), cv2.DIST_L2, 5)
    half_gap, half_road = (np.asarray(maximum(layer, labels, keys)) for layer in (gap, road))
    length = areas[keys] / (2 * half_gap)
    thinner = half_road / half_gap
    painted = (thinner > _THIN) & (length < _SHORT * 2 * half_road) | (thinner > _LINE)
    if not painted.any():
        return surface
    filled = np.isin(np.arange(len(areas)), keys[painted]).take(labels).view(np.uint8)
    around = cv2.dilate(filled, np.ones((5, 5), np.uint8)) > 0
    return np.asarray(np.where(around, np.maximum(surface, road > 2), surface), np.float32)
