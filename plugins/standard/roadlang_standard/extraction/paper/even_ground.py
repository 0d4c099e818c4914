"""Whether a part of a picture is as even as a sheet of paper: seen at once, in a small copy."""

from __future__ import annotations

import cv2
import numpy as np

from ..colors.tones import Image

_SMALL, _WINDOW = 200, 11
"""Longer side of the copy in pixels, and side of the windows that are looked at."""
_NEAR, _EVEN = 0.06, 0.7
"""A window is even if at least `_EVEN` of its pixels are within `_NEAR` of the brightness around
them, as a share."""
_LEAST = 0.06
"""Least share of the picture in even windows: of a small sheet, two fifths are far enough from its
rim. Most photos from above have less, drawings on paper ten times as much."""


def has_even_ground(image: Image) -> bool:
    """Whether paper may be seen in a picture (h, w, 3): most photos from above show none that is so
    even, and need no closer look."""
    scale = min(1.0, _SMALL / max(image.shape[:2]))
    size = (max(1, round(image.shape[1] * scale)), max(1, round(image.shape[0] * scale)))
    small = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    gray = cv2.cvtColor(small, cv2.COLOR_BGR2GRAY).astype(np.float32)
    around = cv2.blur(gray, (_WINDOW, _WINDOW))
    near = (np.abs(gray - around) < _NEAR * around).astype(np.float32)
    even = cv2.blur(near, (_WINDOW, _WINDOW)) >= _EVEN
    return bool(even.mean() >= _LEAST)
