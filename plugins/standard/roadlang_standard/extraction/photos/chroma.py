"""How colored a picture is: haze makes photos from the air pale, those from the ground are not."""

from __future__ import annotations

import cv2
import numpy as np

from ..colors.tones import Image
from .scale import resized

_SIDE = 300
"""The longer side of the copy, pixels, in which colors are measured: noise has none there."""
_GRAY = 128.0
"""Both color channels of what has no color, in 8-bit CIELAB."""


def mean_chroma(image: Image) -> float:
    """The mean CIELAB chroma of a picture (h, w, 3): 0 for gray, 4 to 17 of photos from the air."""
    small = resized(image, min(1.0, _SIDE / max(image.shape[:2])))
    _, red, yellow = cv2.split(cv2.cvtColor(small, cv2.COLOR_BGR2LAB).astype(np.float32) - _GRAY)
    return float(np.hypot(red, yellow).mean())
