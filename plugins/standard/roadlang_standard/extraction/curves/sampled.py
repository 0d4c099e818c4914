"""Values of a layer between its pixels."""

from __future__ import annotations

import cv2
import numpy as np

from ..colors.tones import Layer

_MOST = 32767
"""OpenCV takes neither pictures nor lists of places that are so long."""


def sampled(layer: Layer, x: Layer, y: Layer) -> Layer:
    """The layer (h, w) at places (n, m), bilinear; outside, the value of the nearest pixel."""
    if max(*layer.shape, *x.shape) < _MOST:
        found = cv2.remap(layer, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        return np.asarray(found, np.float32)
    from scipy.ndimage import map_coordinates

    return np.asarray(map_coordinates(layer, [y, x], order=1, mode="nearest"), np.float32)
