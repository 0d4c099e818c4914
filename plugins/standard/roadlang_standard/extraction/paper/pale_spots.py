"""Spots on a sheet that are paler than its ink: a pen draws few, trees and houses in snow many.

The printed lines of squared paper and the shadow of a hand are pale as well, but not many spots.
"""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from ..colors.tones import Layer
from ..masks.ellipses import closed_by
from ..masks.mask_parts import opened_by_square, parts_and_boxes

_TOP, _DARK, _BESIDE = 0.02, 0.6, 3
"""The darkest ink is the `_TOP` quantile. What is darker than `_DARK` of it was drawn, and ink
fades within `_BESIDE` pixels of that."""
_NOISE, _FAINTEST = 3.0, 0.05
"""A spot absorbs at least `_NOISE` times the noise, and at least `_FAINTEST` of the light."""
_BROAD = 5
"""Least width of a spot in pixels: lines of ruled paper are thinner, but in large photos."""
_CUTS = (5, 9)
"""Printed lines that were removed are at most so many pixels thick, or most of them are."""
_LONG = 4.0
"""What is pale and at least `_LONG` times as long as it is wide is a line or a shadow, no spot."""
_LEAST = 0.003
"""Least share of the picture that spots cover."""


def pale_spots(ink: Layer, least: float, noise: float, was_ruled: bool = False) -> int:
    """How many there are in the ink (h, w), 0..1, of a sheet without ruling; ink is `least`. Where
    printed lines were removed, they cut a shadow into squares; closed, what is left of them makes
    others: the fewer count."""
    seen = ink[ink > least]
    if not len(seen):
        return 0
    drawn = (ink > _DARK * float(np.quantile(seen, 1 - _TOP))).astype(np.uint8)
    beside = cv2.dilate(drawn, np.ones((2 * _BESIDE + 1,) * 2, np.uint8)) > 0
    pale = (ink > max(_NOISE * noise, _FAINTEST)) & ~beside
    seen_as = (pale, *(closed_by(pale, cut) for cut in _CUTS)) if was_ruled else (pale,)
    return min(map(_spots, seen_as))


def _spots(pale: Booleans) -> int:
    """How many connected parts of what is pale (h, w) are not long, of those that are broad
    somewhere. Whatever hangs together counts once, or the squares between printed lines would
    count one by one."""
    broad = opened_by_square(pale, _BROAD)
    if broad.mean() < _LEAST:
        return 0
    count, parts, boxes = parts_and_boxes(pale)
    deep = np.zeros(count, np.float32)
    inner = cv2.distanceTransform(pale.view(np.uint8), cv2.DIST_L2, 3)
    np.maximum.at(deep, parts[broad], inner[broad])
    extent = boxes[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    return int(np.count_nonzero((deep > 0) & (extent < _LONG * 2 * deep)))
