"""How much a picture varies around each pixel."""

from __future__ import annotations

import cv2
import numpy as np

from .picture_memo import OncePerPicture
from .tones import Image


@OncePerPicture
def local_spread(image: Image) -> Image:
    """How much the 3 x 3 pixels around each (h, w) vary, in their worst channel."""
    kernel = np.ones((3, 3), np.uint8)
    blue, green, red = cv2.split(cv2.subtract(cv2.dilate(image, kernel), cv2.erode(image, kernel)))
    spread = np.asarray(cv2.max(cv2.max(blue, green), red))
    spread.flags.writeable = False  # others read it as well
    return spread
