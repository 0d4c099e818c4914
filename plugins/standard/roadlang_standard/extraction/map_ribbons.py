"""How much of a color of a map lies in ribbons: strips that keep their width along their length."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np

from roadlang.geometry import Booleans

from .mask_parts import window_around
from .tones import Layer

_WIDTHS = (1.0, 4.5, 9.0, 18.0, 36.0, 72.0)
"""Ribbons are looked at by width, between two of these, in pixels."""
_NEAR, _VARIES, _JAGGED = 0.4, 0.35, 2.1
"""Within so many of the larger widths to each side, the width of a ribbon varies by less than this
share of it, or by less than so many pixels; that of land, parks and buildings grows and shrinks."""
_WIDE = 0.95
"""The quantile of the widths of ribbons that stands for the widest."""
_LONG = 2.5
"""A ribbon is longer than so many widths."""


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
    across = np.where(thin, 2 * inner - 1, 0).astype(np.float32)
    least = np.where(thin, across, np.float32(1e3)).astype(np.float32)
    found = np.zeros_like(thin)
    for low, high in pairwise(_WIDTHS):
        some = thin & (across >= low) & (across < high)
        if np.count_nonzero(some) > _LONG * low:
            window = window_around(some, int(_NEAR * high) + 1)
            found[window] |= _ribbons(some[window], across[window], least[window], high)
    total = float(across.sum())
    widths = across[found]
    wide = float(np.quantile(widths, _WIDE)) if widths.size else 0.0
    return RibbonLines(found, float(widths.size), wide, float(widths.sum()) / max(total, 1.0))


def _ribbons(some: Booleans, across: Layer, least: Layer, high: float) -> Booleans:
    """Where the skeleton of widths below `high` keeps its width over some length."""
    kernel = np.ones((2 * int(_NEAR * high) + 1,) * 2, np.uint8)
    varies = cv2.dilate(across, kernel) - cv2.erode(least, kernel)
    even = some & (varies <= np.maximum(_VARIES * across, _JAGGED))
    near = cv2.dilate(even.astype(np.uint8), np.ones((3, 3), np.uint8))
    count, parts = cv2.connectedComponents(near, connectivity=8)
    lengths = np.bincount(parts[even], minlength=count)
    return np.asarray(even & (lengths[parts] > _LONG * across))
