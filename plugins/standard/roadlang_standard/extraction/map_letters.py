"""Where a rendered map is covered by names and road numbers."""

from __future__ import annotations

import cv2
import numpy as np

from roadlang.geometry import Booleans

from .tones import Image

_STROKE, _GLYPH, LARGER = 7, 18, 6.0
"""Letters have strokes thinner than this, and are at most so large, in pixels; more on maps whose
roads are wider than so many pixels."""
_CONTRASTS, _INK = (30, 60, 120), 1.8
"""Contrasts of letters in gray levels, and their ink: at least so many pixels a pixel of size."""


def letters_of_map(image: Image, width: float) -> Booleans:
    """Where words and numbers are (h, w): small strokes much darker or lighter than around them.

    `width` is the usual one of the roads, pixels.
    """
    gray = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    larger = max(1.0, width / LARGER)
    glyph = round(_GLYPH * larger)
    stroke = 2 * round(larger * (_STROKE - 1) / 2) + 1
    kernel = np.ones((stroke, stroke), np.uint8)
    found = np.zeros(gray.shape, np.uint8)
    for kind in (cv2.MORPH_BLACKHAT, cv2.MORPH_TOPHAT):
        strokes = cv2.morphologyEx(gray, kind, kernel)
        for contrast in _CONTRASTS:
            _add_glyphs(found, strokes > contrast, glyph, _INK * larger)
    if not found.any():
        return np.zeros(gray.shape, bool)
    near = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (glyph // 2, glyph // 2))
    words = cv2.morphologyEx(found, cv2.MORPH_CLOSE, near)
    # A speck alone is no word.
    _, parts, stats, _ = cv2.connectedComponentsWithStats(words, connectivity=8)
    long = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1) >= glyph
    long[0] = False
    return np.asarray(cv2.dilate(long[parts].astype(np.uint8), np.ones((5, 5), np.uint8)) > 0)


def without_letters(image: Image, letters: Booleans) -> Image:
    """A map (h, w, 3) whose `letters` (h, w) have the color of the nearest pixel beside them."""
    if not letters.any() or letters.all():
        return image
    _, nearest = cv2.distanceTransformWithLabels(
        letters.astype(np.uint8), cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
    )
    source = np.zeros(int(nearest.max()) + 1, np.intp)
    source[nearest[~letters]] = np.flatnonzero(~letters)
    return np.asarray(image.reshape(-1, 3)[source[nearest]])


def _add_glyphs(found: Image, strokes: Booleans, largest: int, ink: float) -> None:
    """Mark the parts of a mask (h, w) that are as small and as full as letters, in place."""
    x, y, width, height = cv2.boundingRect(strokes.view(np.uint8))
    if not width:
        return
    window = (slice(y, y + height), slice(x, x + width))
    around = np.ascontiguousarray(strokes[window]).view(np.uint8)
    _, parts, stats, _ = cv2.connectedComponentsWithStats(around, connectivity=8)
    sizes = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    # Straight dashes have less ink for their size: edges of roads that come and go.
    small = (sizes <= largest) & (stats[:, cv2.CC_STAT_AREA] >= ink * sizes)
    small[0] = False
    if small.any():
        found[window] |= small.take(parts).view(np.uint8)
