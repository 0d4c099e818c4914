"""How much of a color of a map lies in ribbons: strips that keep their width along their length."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Layer

Pixels = NDArray[np.intp]

_WIDTHS = (1.0, 4.5, 9.0, 18.0, 36.0, 72.0)
"""Ribbons are searched separately for widths between two of these, in pixels."""
_AROUND = 15
"""Side, in pixels, of the window in which the mean width around a pixel is computed."""
_NEAR, _VARIES, _JAGGED = 0.4, 0.35, 2.1
"""Within `_NEAR` of the larger width to each side, the width of a ribbon varies by at most
`_VARIES` of it, or by `_JAGGED` pixels; the width of land, parks and buildings varies more."""
_WIDE = 0.95
"""This quantile of the widths of ribbons counts as their greatest width."""
_LONG = 2.5
"""A ribbon is at least this many times as long as wide."""


@dataclass(frozen=True)
class RibbonLines:
    """Where the center lines of the ribbons are (h, w), their length, the width of their widest
    twentieth (pixels), and their share of the surface."""

    lines: Booleans
    length: float
    wide: float
    share: float


def ribbons(thin: Booleans, inner: Layer) -> RibbonLines:
    """What of a surface is ribbons.

    `thin` (h, w) is the skeleton of the surface, `inner` (h, w) how far pixels are from its edge.
    """
    at = np.flatnonzero(thin)
    return ribbons_along((thin.shape[0], thin.shape[1]), at, 2 * inner.ravel()[at] - 1)


def ribbons_along(size: tuple[int, int], at: Pixels, widths: Layer) -> RibbonLines:
    """As `ribbons` of a picture of some `size`, given the pixels (n,) of the skeleton, as indices
    of the flat picture, and the width (n,) of the surface there."""
    across, least = np.zeros(size, np.float32), np.full(size, 1e3, np.float32)
    across.ravel()[at] = least.ravel()[at] = widths
    found, thin = np.zeros(size, bool), np.zeros(size, bool)
    thin.ravel()[at] = True
    usual = _usual(across, thin, at)
    for low, high in pairwise(_WIDTHS):
        some = at[(usual >= low) & (usual < high)]
        if len(some) > _LONG * low:
            found.ravel()[_ribbons(some, across, least, high)] = True
    total = float(widths.sum(dtype=np.float64))
    even = widths[found.ravel()[at]]
    wide = float(np.quantile(even, _WIDE)) if even.size else 0.0
    share = float(even.sum(dtype=np.float64)) / max(total, 1.0)
    return RibbonLines(found, float(even.size), wide, share)


def _usual(across: Layer, thin: Booleans, at: Pixels) -> Layer:
    """The mean width around each pixel of a skeleton. Without the mean, a strip about as wide as
    the limit between two classes of widths would change class from pixel to pixel."""
    side = (_AROUND, _AROUND)
    total = cv2.boxFilter(across, -1, side, normalize=False, borderType=cv2.BORDER_CONSTANT)
    count = cv2.boxFilter(  # at most 225: a byte holds it
        thin.view(np.uint8), -1, side, normalize=False, borderType=cv2.BORDER_CONSTANT
    )
    return np.asarray(total.ravel()[at] / np.maximum(count.ravel()[at], 1))


def _ribbons(some: Pixels, across: Layer, least: Layer, high: float) -> Pixels:
    """Which pixels, of `some` of a skeleton (h, w) with widths below `high`, keep their width over
    some length. All pixels are indices of the flat picture."""
    kernel = np.ones((2 * int(_NEAR * high) + 1,) * 2, np.uint8)
    rows, columns = np.divmod(some, across.shape[1])
    margin = int(_NEAR * high) + 1
    top, left = (max(0, int(axis.min()) - margin) & ~1 for axis in (rows, columns))
    window = slice(top, int(rows.max()) + margin), slice(left, int(columns.max()) + margin)
    within = rows - top, columns - left
    widths = across.ravel()[some]
    varies = cv2.dilate(across[window], kernel)[within] - cv2.erode(least[window], kernel)[within]
    even = varies <= np.maximum(_VARIES * widths, _JAGGED)
    lines = np.zeros(across[window].shape, np.uint8)
    lines[within] = even
    near = cv2.dilate(lines, np.ones((3, 3), np.uint8))
    count, parts = cv2.connectedComponents(near, connectivity=8)
    part = parts[within]
    lengths = np.bincount(part[even], minlength=count)
    return np.asarray(some[even & (lengths[part] > _LONG * widths)])
