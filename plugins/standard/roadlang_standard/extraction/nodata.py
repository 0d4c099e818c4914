"""Where a picture shows nothing: the black or white margins of turned and cut orthophotos."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from .tones import Image

_BLACK, _WHITE = 8, 248
_LEAST = 0.004
"""Margins smaller than this share of the picture are left alone."""


def nodata(image: Image) -> NDArray[np.bool_] | None:
    """Margins (h, w) of pure black or white that touch the rim; None where there are none."""
    found = np.zeros(image.shape[:2], np.uint8)
    blue, green, red = cv2.split(image)
    brightest = cv2.max(cv2.max(blue, green), red)
    darkest = cv2.min(cv2.min(blue, green), red)
    for pure in (brightest <= _BLACK, darkest >= _WHITE):
        if _rim(pure).mean() > 0.01:
            found |= _touching(pure.astype(np.uint8))
    return found.astype(bool) if found.any() else None


def _rim(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    return np.concatenate([mask[0], mask[-1], mask[:, 0], mask[:, -1]])


def _touching(mask: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The large parts of a mask that touch the rim, without what is thin."""
    thick = cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((5, 5), np.uint8))
    count, labels, stats, _ = cv2.connectedComponentsWithStats(thick)
    selected = np.zeros(count, np.uint8)
    selected[np.unique(_rim(labels))] = 1
    selected[stats[:, cv2.CC_STAT_AREA] < _LEAST * mask.size] = 0
    selected[0] = 0
    return np.asarray(selected[labels], np.uint8)
