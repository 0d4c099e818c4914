"""Where a rendered map is covered by names and road numbers."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Image
from ..masks.ellipses import closed_by
from ..masks.mask_parts import parts_and_boxes, where_parts, window_around

_STROKE, _GLYPH, LARGER = 7, 18, 6.0
"""Letters have strokes thinner than `_STROKE` pixels and are at most `_GLYPH` pixels large;
proportionally more on maps whose roads are wider than `LARGER` pixels."""
_CONTRASTS, _INK = (30, 60, 120), 1.8
"""Contrasts of letters in gray levels, and the least number of ink pixels of a letter per pixel of
its size."""
_MANY = 0.06
"""If more than this share of all pixels is set, arrays are faster than lists of pixels."""
_BESIDE, _WORDS, _FULL = 3, 200, 0.3
"""Up to `_WORDS` words that cover at most `_FULL` of the picture are filled one by one, each with a
margin of `_BESIDE` pixels; otherwise all at once."""


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
    window = window_around(found, glyph)  # closing looks half as far to each side
    words = closed_by(found[window] > 0, glyph // 2)
    # A speck alone is no word.
    _, parts, stats = parts_and_boxes(words)
    long = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1) >= glyph
    long[0] = False
    grown = cv2.dilate(where_parts(long, parts).view(np.uint8), np.ones((5, 5), np.uint8))
    letters = np.zeros(gray.shape, bool)
    letters[window] = grown > 0
    return letters


def without_letters(image: Image, letters: Booleans) -> Image:
    """A map (h, w, 3) whose `letters` (h, w) have the color of the nearest pixel beside them."""
    if not letters.any() or letters.all():
        return image
    around = cv2.dilate(letters.view(np.uint8), np.ones((2 * _BESIDE + 1,) * 2, np.uint8))
    count, parts, boxes = parts_and_boxes(around > 0)
    plain = image.copy()
    if count > _WORDS or boxes[1:, 2:4].prod(axis=1).sum() > _FULL * letters.size:
        _fill(plain, image, letters, letters)
        return plain
    for part, (left, top, width, height, _) in enumerate(boxes[1:].tolist(), start=1):
        window = (slice(top, top + height), slice(left, left + width))
        within = letters[window]
        _fill(plain[window], image[window], within, within & (parts[window] == part))
    return plain


def _fill(plain: Image, image: Image, letters: Booleans, some: Booleans) -> None:
    """Give `some` (h, w) of the letters of a map the color of the pixel beside them, in place."""
    _, nearest = cv2.distanceTransformWithLabels(
        letters.astype(np.uint8), cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL
    )
    source = np.zeros(int(nearest.max()) + 1, np.intp)
    source[nearest[~letters]] = np.flatnonzero(~letters)
    plain[some] = image[np.divmod(source[nearest[some]], letters.shape[1])]


def _add_glyphs(found: Image, strokes: Booleans, largest: int, ink: float) -> None:
    """Mark the parts of a mask (h, w) that are as small and as full as letters, in place."""
    x, y, width, height = cv2.boundingRect(strokes.view(np.uint8))
    if not width:
        return
    window = (slice(y, y + height), slice(x, x + width))
    around = np.ascontiguousarray(strokes[window])
    pixels = np.flatnonzero(around)
    parts, sizes, areas = _parts(around, pixels)
    # Straight dashes have less ink for their size: edges of roads that come and go.
    small = (sizes <= largest) & (areas >= ink * sizes)
    small[0] = False
    if small.any():
        chosen = pixels[small[parts.ravel()[pixels]]]
        found[window][np.divmod(chosen, width)] = 1


def _parts(
    mask: Booleans, pixels: NDArray[np.intp]
) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.intp]]:
    """The label (h, w) of each part of a mask, how far each of them (n,) reaches, and how many
    pixels it has; the `pixels` (p,) of all are indices of the flat mask.

    Letters and outlines are few of the pixels: to look at these takes a fifth of the time.
    """
    if len(pixels) > _MANY * mask.size:
        _, parts, stats = parts_and_boxes(mask)
        extents = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
        return parts, extents, stats[:, cv2.CC_STAT_AREA].astype(np.intp)
    count, parts = cv2.connectedComponents(mask.view(np.uint8), connectivity=8)
    owner = parts.ravel()[pixels]
    sizes = np.zeros(count, np.int32)
    for axis in np.divmod(pixels, mask.shape[1]):
        low, high = np.full(count, mask.size), np.zeros(count, np.intp)
        np.minimum.at(low, owner, axis)
        np.maximum.at(high, owner, axis)
        sizes = np.maximum(sizes, (high - low + 1).astype(np.int32))
    return np.asarray(parts, np.int32), sizes, np.bincount(owner, minlength=count)
