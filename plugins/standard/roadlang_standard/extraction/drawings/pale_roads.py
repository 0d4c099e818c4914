"""Roads that are hardly lighter or darker than the ground, among names that are far darker."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from ..colors.tones import Image, Layer

_LEAST, _APART, _CLEAR = 0.02, 10.0, 0.85
"""Each of the two tones covers at least `_LEAST` of the picture without the names. They are more
than `_APART` gray levels apart, and explain more than `_CLEAR` of the variance of gray."""
_AROUND = 15
"""Side of the windows, in pixels, from which the tone below a name is taken."""


def pale_surfaces(gray: Image, level: float) -> tuple[Layer, Layer] | None:
    """The lighter and the darker one (h, w), 0..1, of two tones of a ground, given the gray that
    parts the names from it; None if there are no two."""
    dark = gray < level
    names = dark if dark.mean() < 0.5 else ~dark
    names = cv2.dilate(names.view(np.uint8), np.ones((3, 3), np.uint8)) > 0
    shown = gray[~names]
    if not len(shown):
        return None
    between, _ = cv2.threshold(shown.reshape(-1, 1), 0, 255, cv2.THRESH_BINARY | cv2.THRESH_OTSU)
    low, high = shown[shown <= between], shown[shown > between]
    if min(len(low), len(high)) < _LEAST * gray.size or not _are_two_tones(low, high, shown):
        return None
    first, last = float(np.median(low)), float(np.median(high))
    light = np.clip((gray.astype(np.float32) - first) / (last - first), 0, 1)
    light = _beneath(light, names)
    return light, 1 - light


def _are_two_tones(
    low: NDArray[np.uint8], high: NDArray[np.uint8], both: NDArray[np.uint8]
) -> bool:
    apart = float(high.mean() - low.mean())
    share = len(low) / len(both)
    return apart > _APART and share * (1 - share) * apart**2 > _CLEAR * float(both.var())


def _beneath(light: Layer, names: NDArray[np.bool_]) -> Layer:
    """The layer with what is around the names in their place."""
    seen = (~names).astype(np.float32)
    size = (_AROUND, _AROUND)
    total, count = cv2.blur(light * seen, size), cv2.blur(seen, size)
    return np.asarray(np.where(names, total / np.maximum(count, 1e-6), light), np.float32)
