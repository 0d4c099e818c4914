"""Lines painted on a drawn road, such as dashes along its middle: they are road as well."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum, sum_labels

from roadlang.geometry import Booleans

from .mask_parts import parts_of
from .tones import Image, Layer

_THIN = 5.0
"""A marking has at least so many times its thickness of road around it, ..."""
_SHORT = 2.5
"""and is at most so many widths of the road long: a longer one is a median, ..."""
_LINE = 6.0
"""unless it is so many times as thin."""
_COLORED = 3.0
"""How many times as thin a marking is that has a color where road and ground have none."""
_ENCLOSED = 0.6
"""Share of what is around such a marking that is road."""
_LARGEST = 0.02
"""No part that is more of the picture is a marking."""
_CHROMA = 60
_FEWEST, _MOST_COLORED = 20, 0.05
"""Pixels, and share of the picture: where more has a color, road and ground may have one too."""


def with_markings_filled(surface: Layer, image: Image | None = None) -> Layer:
    """The surface (h, w), 0..1, with thin gaps within its roads filled; itself if there are none.

    `image`: (h, w, 3), where lines may have a color of their own, as of a yellow center line.
    """
    mask = (surface >= 0.5).astype(np.uint8)
    filled = _plain_gaps(mask)
    colored = None if image is None else _colored(image)
    if colored is not None:
        filled = filled | _colored_gaps(mask, colored)
    if not filled.any():
        return surface
    road = cv2.distanceTransform(mask | filled.view(np.uint8), cv2.DIST_L2, 5)
    around = cv2.dilate(filled.view(np.uint8), np.ones((5, 5), np.uint8)) > 0
    return np.asarray(np.where(around, np.maximum(surface, road > 2), surface), np.float32)


def _colored(image: Image) -> Booleans | None:
    """(h, w) the pixels with a color, of a picture in which few have one."""
    channels = cv2.split(image)
    chroma = cv2.subtract(cv2.max(cv2.max(*channels[:2]), channels[2]),
                          cv2.min(cv2.min(*channels[:2]), channels[2]))  # fmt: skip
    found = chroma > _CHROMA
    count = int(np.count_nonzero(found))
    return found if _FEWEST <= count <= _MOST_COLORED * found.size else None


def _plain_gaps(mask: NDArray[np.uint8]) -> Booleans:
    """(h, w) thin parts that are no road, and are short or as thin as lines."""
    labels, areas, keys = _small_parts(mask == 0)
    if not len(keys):
        return np.zeros(mask.shape, bool)
    thickness, width = _sizes(mask, labels, areas, keys)
    thinner, length = width / thickness, areas[keys] / thickness
    is_marking = (thinner > _THIN) & (length < _SHORT * width) | (thinner > _LINE)
    return _union(labels, areas, keys[is_marking])


def _colored_gaps(mask: NDArray[np.uint8], colored: Booleans) -> Booleans:
    """(h, w) thin parts within roads that have a color, however long."""
    labels, areas, keys = _small_parts((mask == 0) & colored)
    if not len(keys):
        return np.zeros(mask.shape, bool)
    thickness, width = _sizes(mask, labels, areas, keys)
    # The smaller label where two meet: there are few such pixels.
    rim = cv2.dilate(labels.astype(np.float32), np.ones((3, 3), np.uint8)).astype(np.int32)
    rim[labels > 0] = 0
    around = np.bincount(rim.ravel(), minlength=len(areas))[keys]
    road = np.asarray(sum_labels(mask, rim, keys)) / np.maximum(around, 1)
    return _union(labels, areas, keys[(width / thickness > _COLORED) & (road > _ENCLOSED)])


def _small_parts(
    gaps: Booleans,
) -> tuple[NDArray[np.int32], NDArray[np.int64], NDArray[np.int64]]:
    """The labels (h, w) of parts, their areas, and the labels of small ones."""
    count, labels = parts_of(gaps)
    areas = np.bincount(labels.ravel(), minlength=count)
    keys = np.flatnonzero(areas < _LARGEST * gaps.size)
    return labels, areas, keys[keys > 0]


def _sizes(
    mask: NDArray[np.uint8],
    labels: NDArray[np.int32],
    areas: NDArray[np.int64],
    keys: NDArray[np.int64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """How thick these parts are, and how wide the road is with them, pixels."""
    parts = _union(labels, areas, keys).view(np.uint8)
    gap = cv2.distanceTransform(parts, cv2.DIST_L2, 5)
    road = cv2.distanceTransform(mask | parts, cv2.DIST_L2, 5)
    # A line one pixel thick is at 1 from what is around it.
    # Where nothing else is in the picture, OpenCV's distance is the greatest number there is.
    most = (np.asarray(maximum(layer, labels, keys), np.float64) for layer in (gap, road))
    thickness, width = (2 * distance - 1 for distance in most)
    return thickness, width


def _union(
    labels: NDArray[np.int32], areas: NDArray[np.int64], keys: NDArray[np.int64]
) -> Booleans:
    """(h, w) where these parts are."""
    return np.isin(np.arange(len(areas)), keys).take(labels)
