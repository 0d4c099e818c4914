"""The title bars of slides: filled rectangles along a whole side of the picture."""

from __future__ import annotations

import numpy as np

from ..colors.tones import Layer
from ..masks.mask_parts import parts_and_boxes, where_parts

_ALONG, _THICK = 0.97, 0.25
"""A bar extends over at least `_ALONG` of a side, and is at most `_THICK` of the other thick."""
_FILLED = 0.75
"""Least share of its box that it fills; letters are the rest. A road along a side bends more."""


def without_title_bars(surface: Layer) -> Layer:
    """The surface (h, w), 0..1, without title bars; itself if it has none."""
    mask = surface >= 0.5
    if all(side.mean() < _ALONG for side in (mask[0], mask[-1], mask[:, 0], mask[:, -1])):
        return surface
    height, width = mask.shape
    _, parts, boxes = parts_and_boxes(mask)
    left, top, wide, high, area = boxes.T
    along = (wide >= _ALONG * width) & (high <= _THICK * height)
    along &= (top == 0) | (top + high == height)
    down = (high >= _ALONG * height) & (wide <= _THICK * width)
    down &= (left == 0) | (left + wide == width)
    bars = (along | down) & (area >= _FILLED * wide * high)
    bars[0] = False
    return np.where(where_parts(bars, parts), np.float32(0), surface) if bars.any() else surface
