"""The usual color along the borders of pictures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray


def border_color(pictures: Sequence[NDArray[np.uint8]]) -> tuple[float, ...]:
    """(3,) the median of the outermost pixels of pictures (height, width, 3)."""
    edges = [
        side.reshape(-1, 3) for pixels in pictures for side in (pixels[[0, -1]], pixels[:, [0, -1]])
    ]
    return tuple(float(value) for value in np.median(np.concatenate(edges), axis=0))
