"""A picture in the pixels of another."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..geometry.earth.pixel_map import PixelMap


def mapped(
    pixels: NDArray[np.uint8], to: PixelMap | None, *, blends: bool = True
) -> NDArray[np.uint8]:
    """`pixels` (h, w) or (h, w, 3) drawn where `to` has them; as they are if it is None.

    `blends`: colors between those of neighbors may arise. What they do not show is black.
    """
    if to is None:
        return pixels
    import cv2

    how = cv2.INTER_LINEAR if blends else cv2.INTER_NEAREST
    matrix = np.array(to.matrix).reshape(2, 3)
    return np.asarray(cv2.warpAffine(pixels, matrix, (to.width, to.height), flags=how), np.uint8)
