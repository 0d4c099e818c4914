"""Brought to one brightness and contrast, so that those of a photo do not matter."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from ..colors.nodata import nodata
from ..curves.sampled import sampled

_MEAN, _DEVIATION = 115.0, 50.0
_WINDOW, _CELL = 384, 8
"""Side in pixels of what is evened at a time, and of the cells it is measured by."""

Layer = NDArray[np.float32]


@dataclass(frozen=True)
class EvenView:
    """A picture as nets see it: `even` (h, w, 3) by `even_exposure`, and where it shows `nothing`
    (h, w), None where it does everywhere."""

    even: NDArray[np.uint8]
    nothing: NDArray[np.bool_] | None


def even_exposure(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The picture (h, w, 3) with a gray mean of 115 and a deviation of 50 wherever one looks.

    Measured in windows as large as the crops that the net learns from, so that a dark sea, or a
    margin without data, does not change how the land beside it looks.
    """
    return even_view(image).even


def even_view(image: NDArray[np.uint8]) -> EvenView:
    """The picture (h, w, 3) with its exposure made even, and its margins without data."""
    nothing = nodata(image)
    gain, offset = _gain_and_offset(image, nothing)
    even = np.empty_like(image)
    height, width = image.shape[:2]
    x = ((np.arange(width) + 0.5) / _CELL - 0.5).astype(np.float32)
    for top in range(0, height, 256):
        rows = np.arange(top, min(top + 256, height))
        y = ((rows + 0.5) / _CELL - 0.5).astype(np.float32)
        at = np.tile(x, (len(y), 1)), np.repeat(y, width).reshape(-1, width)
        part = image[top : top + 256].astype(np.float32)
        part *= _in_channels(gain, *at)
        part += _in_channels(offset, *at)
        np.clip(part, 0, 255, out=part)
        even[top : top + 256] = np.rint(part, out=part)
    if nothing is not None:
        even[nothing] = int(_MEAN)
    return EvenView(even, nothing)


def _in_channels(field: Layer, x: Layer, y: Layer) -> Layer:
    """The field at places (h, w), for each of three channels (h, w, 3)."""
    return np.asarray(cv2.merge([sampled(field, x, y)] * 3), np.float32)


def _gain_and_offset(
    image: NDArray[np.uint8], nothing: NDArray[np.bool_] | None
) -> tuple[Layer, Layer]:
    """What to multiply by, and then to add, for each cell of the picture."""
    gray = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    seen = np.ones(gray.shape, np.float32)
    if nothing is not None:
        seen[cv2.dilate(nothing.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0] = 0
    light = gray.astype(np.float32) * seen
    share, first, second = (_windows(_cells(field)) for field in (seen, light, light * gray))
    share = np.maximum(share, 1e-3)
    mean = first / share
    deviation = np.sqrt(np.maximum(second / share - mean**2, 1.0))
    gain = np.clip(_DEVIATION / deviation, 0.4, 4.0).astype(np.float32)
    return gain, (_MEAN - gain * mean).astype(np.float32)


def _cells(field: Layer) -> Layer:
    """Means over cells; those at the far edges are made whole by reflection."""
    height, width = field.shape
    border = cv2.BORDER_REFLECT if min(height, width) > _CELL else cv2.BORDER_REPLICATE
    padded = cv2.copyMakeBorder(field, 0, -height % _CELL, 0, -width % _CELL, border)
    size = (padded.shape[1] // _CELL, padded.shape[0] // _CELL)
    return np.asarray(cv2.resize(padded, size, interpolation=cv2.INTER_AREA), np.float32)


def _windows(cells: Layer) -> Layer:
    """Means over windows about each cell, the picture mirrored at its edges."""
    side = _WINDOW // _CELL
    wide, high = (min(side, 2 * count - 1) | 1 for count in cells.shape[::-1])
    return np.asarray(cv2.blur(cells, (wide, high), borderType=cv2.BORDER_REFLECT), np.float32)
