"""Two thresholds: what is weak is kept where it hangs on to what is strong."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray


def hysteresis(score: NDArray[np.float32], high: float, low: float) -> NDArray[np.bool_]:
    """Parts of {score > low} (h, w) that hold a pixel of {score > high}."""
    weak = score > low
    count, labels = cv2.connectedComponents(weak.view(np.uint8), connectivity=8)
    strong = np.zeros(count, bool)
    strong[np.unique(labels[score > high])] = True
    strong[0] = False
    return np.asarray(strong.take(labels))
