"""Whether words are written in dark letters on light ground: on black maps, but on no masks."""

from __future__ import annotations

import cv2
import numpy as np

from .tones import Image

_DARK = 128
"""Ink is darker than this gray level."""
_SMALL, _LARGE, _INK, _FULL = 5, 18, 1.8, 0.8
"""Letters are `_SMALL` to `_LARGE` pixels large, have at least `_INK` pixels of ink per pixel of
that, and cover at most `_FULL` of their box: holes between roads have hardly any ink, or all."""
_NEAR, _WORD = 9, 5
"""At least `_WORD` letters less than `_NEAR` pixels apart are a word."""


def has_dark_words(image: Image) -> bool:
    """Whether a picture (h, w, 3) has a word in dark letters on light ground."""
    ink = (cv2.cvtColor(image, cv2.COLOR_BGR2GRAY) < _DARK).astype(np.uint8)
    _, parts, stats, _ = cv2.connectedComponentsWithStats(ink, connectivity=8)
    left, top, width, height, area = stats.T
    size = np.maximum(width, height)
    inside = (left > 0) & (top > 0)
    inside &= (left + width < ink.shape[1]) & (top + height < ink.shape[0])
    letters = inside & (size >= _SMALL) & (size <= _LARGE)
    letters &= (area >= _INK * size) & (area <= _FULL * width * height)
    if letters.sum() < _WORD:
        return False
    glyphs = letters[parts].astype(np.uint8)
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (_NEAR, _NEAR))
    _, words = cv2.connectedComponents(cv2.morphologyEx(glyphs, cv2.MORPH_CLOSE, kernel))
    pairs = np.unique(np.stack([words[glyphs > 0], parts[glyphs > 0]]), axis=1)
    return bool(np.bincount(pairs[0]).max() >= _WORD)
