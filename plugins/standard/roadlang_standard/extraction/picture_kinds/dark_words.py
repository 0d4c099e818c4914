"""Whether words are written in dark letters on light ground: on black maps, but on no masks."""

from __future__ import annotations

import cv2
import numpy as np

from ..colors.tones import Image
from ..masks.ellipses import closed_by
from ..masks.mask_parts import parts_and_boxes, parts_of, where_parts

_DARK = 128
"""Ink is darker than this gray level."""
_SMALL, _LARGE, _INK, _FULL = 5, 18, 1.8, 0.8
"""Letters are `_SMALL` to `_LARGE` pixels large, have at least `_INK` pixels of ink per pixel of
that, and cover at most `_FULL` of their box: holes between roads have hardly any ink, or all."""
_NEAR, _WORD = 9, 5
"""At least `_WORD` letters less than `_NEAR` pixels apart are a word."""


def has_dark_words(image: Image) -> bool:
    """Whether a picture (h, w, 3) has a word in dark letters on light ground."""
    ink = np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY) < _DARK)
    _, parts, boxes = parts_and_boxes(ink)
    left, top, width, height, area = boxes.T
    size = np.maximum(width, height)
    inside = (left > 0) & (top > 0)
    inside &= (left + width < ink.shape[1]) & (top + height < ink.shape[0])
    letters = inside & (size >= _SMALL) & (size <= _LARGE)
    letters &= (area >= _INK * size) & (area <= _FULL * width * height)
    letters[0] = False
    if letters.sum() < _WORD:
        return False
    glyphs = where_parts(letters, parts)
    _, words = parts_of(closed_by(glyphs, _NEAR), 8)
    pairs = np.unique(np.stack([words[glyphs], parts[glyphs]]), axis=1)
    return bool(np.bincount(pairs[0]).max() >= _WORD)
