"""Overexposed paper: pure white in the light, as a screen is, but with the noise of a camera in the
shade."""

from __future__ import annotations

import cv2
import numpy as np

from .local_spread import local_spread
from .tones import Image

WHITE = 252
"""Overexposed pixels are at least this light in all channels."""
_SHADE, _BROAD, _LEAST = 140, 9, 0.03
"""What is darker than white, but not than `_SHADE`, and at least `_BROAD` pixels wide is shade; it
covers at least `_LEAST` of the picture."""
_STILL, _NOISY = 1, 0.5
"""Less than `_NOISY` of it varies by at most `_STILL` gray levels around each pixel: what was drawn
on a screen is even."""


def is_overexposed(image: Image) -> bool:
    """Whether a picture (h, w, 3) that is mostly white is a photo of paper."""
    least = image.min(axis=2)
    shade = ((least >= _SHADE) & (least < WHITE)).view(np.uint8)
    broad = cv2.morphologyEx(shade, cv2.MORPH_OPEN, np.ones((_BROAD, _BROAD), np.uint8)) > 0
    if np.count_nonzero(broad) < _LEAST * broad.size:
        return False
    still = np.count_nonzero((local_spread(image) <= _STILL) & broad)
    return bool(still < _NOISY * np.count_nonzero(broad))
