"""Where a picture shows nothing: the black or white margins of turned and cut orthophotos."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from .tones import Image

_BLACK, _WHITE = 8, 248
_LEAST = 0.004
"""Margins smaller than this share of the picture are left alone,"""
_LONG = 0.1
"""unless they extend along this share of its shorter side: a photo that was rotated a little."""
_THIN = 5
"""What is narrower, in pixels, is no margin, except along the rim, which cuts margins off."""


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


def _rim(mask: NDArray[Any]) -> NDArray[Any]:
    return np.concatenate([mask[0], mask[-1], mask[:, 0], mask[:, -1]])


def _touching(mask: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The large and the long parts of a mask that touch the rim, without what is thin."""
    beyond = cv2.copyMakeBorder(mask, *4 * [_THIN], cv2.BORDER_REPLICATE)
    opened = cv2.morphologyEx(beyond, cv2.MORPH_OPEN, np.ones((_THIN, _THIN), np.uint8))
    thick = np.ascontiguousarray(opened[_THIN:-_THIN, _THIN:-_THIN])
    count, labels, stats, _ = cv2.connectedComponentsWithStats(thick)
    along = np.bincount(_rim(labels), minlength=count)
    large = stats[:, cv2.CC_STAT_AREA] >= _LEAST * mask.size
    selected = (along > 0) & (large | (along >= _LONG * min(mask.shape)))
    selected[0] = False
    return np.asarray(selected[labels], np.uint8)
