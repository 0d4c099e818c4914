"""Spots on a sheet that are paler than its ink: a pen draws few, trees and houses in snow many."""

from __future__ import annotations

import cv2
import numpy as np

from ..colors.tones import Layer

_TOP, _DARK, _BESIDE = 0.02, 0.6, 3
"""The darkest ink is the `_TOP` quantile. What is darker than `_DARK` of it was drawn, and ink
fades within `_BESIDE` pixels of that."""
_NOISE, _FAINTEST = 3.0, 0.05
"""A spot absorbs at least `_NOISE` times the noise, and at least `_FAINTEST` of the light."""
_BROAD = 5
"""Least width of a spot in pixels: lines of ruled paper are thinner."""
_LEAST = 0.003
"""Least share of the picture that spots cover."""


def pale_spots(ink: Layer, least: float, noise: float) -> int:
    """How many there are in the ink (h, w), 0..1, of a sheet without ruling; ink is `least`."""
    seen = ink[ink > least]
    if not len(seen):
        return 0
    drawn = (ink > _DARK * float(np.quantile(seen, 1 - _TOP))).astype(np.uint8)
    beside = cv2.dilate(drawn, np.ones((2 * _BESIDE + 1,) * 2, np.uint8)) > 0
    pale = (ink > max(_NOISE * noise, _FAINTEST)) & ~beside
    broad = cv2.morphologyEx(pale.view(np.uint8), cv2.MORPH_OPEN, np.ones((_BROAD,) * 2, np.uint8))
    if broad.mean() < _LEAST:
        return 0
    count, _ = cv2.connectedComponents(broad)
    return int(count) - 1
