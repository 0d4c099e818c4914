"""One global gain and offset, so that brightness and contrast of a photo do not matter."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_MEAN, _DEVIATION = 115.0, 50.0


def even_exposure(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The picture (h, w, 3) brought to a grey mean of 115 and a deviation of 50."""
    step = max(1, int(np.sqrt(image.shape[0] * image.shape[1] / 250_000)))
    grey = image[::step, ::step].mean(axis=2, dtype=np.float64)
    gain = float(np.clip(_DEVIATION / max(grey.std(), 1.0), 0.4, 4.0))
    table = np.clip((np.arange(256) - grey.mean()) * gain + _MEAN, 0, 255).round().astype(np.uint8)
    return table[image]
