"""Shadows of fingers and pens on a sheet: broader than its strokes, and fainter."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..colors.tones import Layer

_BROADER = 3.0
"""A shadow is more than `_BROADER` times as broad as the strokes usually are."""
_TOP, _FAINTER = 0.02, 0.6
"""It takes less than `_FAINTER` of the light that the darkest ink does, its `_TOP` quantile."""


def without_cast_shadows(ink: Layer, marked: Booleans) -> Layer:
    """The ink (h, w) less what a shadow takes where it is `marked` (h, w); itself without one."""
    inner = cv2.distanceTransform(marked.view(np.uint8), cv2.DIST_L2, 5)
    ridge = inner[(inner >= cv2.dilate(inner, np.ones((3, 3), np.uint8))) & marked]
    if not len(ridge):
        return ink
    broad = _BROADER * max(1.0, 2 * float(np.median(ridge)) - 1)
    if 2 * float(ridge.max()) - 1 <= broad:
        return ink
    side = 2 * round(broad / 2) + 1
    shade = cv2.morphologyEx(ink, cv2.MORPH_OPEN, np.ones((side, side), np.uint8))
    darkest = float(np.quantile(ink[marked], 1 - _TOP))
    shade[shade >= _FAINTER * darkest] = 0  # ink that covers a surface
    return np.asarray(np.maximum(ink - shade, 0))
