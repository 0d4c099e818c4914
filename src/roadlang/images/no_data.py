"""What a file says is no data: a margin about what it shows, or the ground of lines."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

_DEEP, _SOLID = 0.05, 0.5
"""What a margin surrounds is solid: at least `_SOLID` of it is farther than `_DEEP` of the
picture's shorter side from what is not shown. Roads on a mask are not."""
_ALIKE, _FLAT = 8, 0.5
"""A drawing is on flat ground: at least `_FLAT` of what is shown differs by at most `_ALIKE` of 255
levels from the median."""


def within_margins(shown: NDArray[np.bool_] | None) -> NDArray[np.bool_] | None:
    """Where a picture shows something, (height, width), if the rest of it is a margin; None if it
    is the ground of lines, as in a mask whose background is no data."""
    if shown is None or not shown.any():
        return None
    away = cv2.distanceTransform(shown.astype(np.uint8), cv2.DIST_L2, 3)
    deep = away[shown] > _DEEP * min(shown.shape)
    return shown if deep.mean() >= _SOLID else None


def on_its_ground(pixels: NDArray[np.uint8], shown: NDArray[np.bool_] | None) -> NDArray[np.uint8]:
    """Pixels (height, width, 3) whose margin has the color of the ground that they are drawn on:
    a black one would be ink. That of a photo, which has no such ground, stays."""
    if shown is None:
        return pixels
    visible = pixels[shown]
    ground = np.median(visible, axis=0)
    if (np.abs(visible - ground).max(axis=1) <= _ALIKE).mean() < _FLAT:
        return pixels
    filled = pixels.copy()
    filled[~shown] = ground
    return filled
