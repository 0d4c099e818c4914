"""The usual color along the borders of pictures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray


def border_color(
    pictures: Sequence[NDArray[np.uint8]], shown: Sequence[NDArray[np.bool_] | None] = ()
) -> tuple[float, ...]:
    """(3,) the median of the outermost pixels of pictures (height, width, 3).

    `shown`, one for each picture: (height, width) where it shows something, None: everywhere.
    """
    masks = shown or [None] * len(pictures)
    sides = (np.s_[[0, -1]], np.s_[:, [0, -1]])
    edges = [pixels[side].reshape(-1, 3) for pixels in pictures for side in sides]
    kept = [
        (np.ones(pixels.shape[:2], np.bool_) if mask is None else mask)[side].ravel()
        for pixels, mask in zip(pictures, masks, strict=True)
        for side in sides
    ]
    colors, visible = np.concatenate(edges), np.concatenate(kept)
    usual = np.median(colors[visible] if visible.any() else colors, axis=0)
    return tuple(float(value) for value in usual)
