"""Pixels that thin lines of a map share with what lies beside them, given to the nearer color."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from .tones import Image

Labels = NDArray[np.int16]
"""Index of the color of each pixel (h, w), -1 for none."""

_STEP = 6
"""A pixel that differs by more from both neighbors, brighter than one and darker than the other, is
on a slope from color to color."""
_WIDE = 5
"""What holds a square of so many pixels is no thin line: its edge stays where its color ends, so
that the outlines beside it still part it from others of its color."""


def with_thin_lines(image: Image, labels: Labels, colors: list[NDArray[np.float64]]) -> Labels:
    """The colors of a map (h, w, 3) with the mixed pixels at thin lines, which renderers smooth.

    A line of two or three pixels has its own color in the middle at most. A mixed pixel is given to
    the nearest of the colors beside it, if that is a thin line's there.
    """
    exact = labels
    labels = np.where(slopes(image), -1, labels).astype(np.int16)
    kernel = np.ones((3, 3), np.uint8)
    left = np.flatnonzero(labels.ravel() < 0)
    pixels = image.reshape(-1, 3)[left].astype(np.int16)
    best = np.full(len(left), 256, np.int16)
    chosen = np.full(len(left), -1, np.int16)
    for index, color in enumerate(colors):
        mask = (labels == index).astype(np.uint8)
        beside = np.flatnonzero(cv2.dilate(mask, kernel).ravel()[left])
        away = np.abs(pixels[beside] - color.round().astype(np.int16)).max(axis=1)
        closer = away < best[beside]
        taken = beside[closer]
        best[taken] = away[closer]
        wide = cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((_WIDE, _WIDE), np.uint8))
        is_wide = cv2.dilate(wide, kernel).ravel()[left[taken]] > 0
        kept = ~is_wide | (exact.ravel()[left[taken]] == index)
        chosen[taken] = np.where(kept, index, -1)
    labels.ravel()[left] = chosen
    return labels


def slopes(image: Image) -> Booleans:
    """Where (h, w) a map is between two colors: mixed pixels may have a third one by chance."""
    gray = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    around = cv2.copyMakeBorder(gray, 1, 1, 1, 1, cv2.BORDER_REPLICATE)
    height, width = gray.shape
    found = np.zeros(gray.shape, bool)
    for down, right in ((0, 1), (1, 0), (1, 1), (1, -1)):
        after = np.ascontiguousarray(around[1 + down :, 1 + right :][:height, :width])
        before = np.ascontiguousarray(around[1 - down :, 1 - right :][:height, :width])
        up = cv2.min(cv2.subtract(after, gray), cv2.subtract(gray, before))  # 0 where it is less
        down_hill = cv2.min(cv2.subtract(gray, after), cv2.subtract(before, gray))
        found |= cv2.max(up, down_hill) > _STEP
    return found
