"""Lines of a pencil: the grain of the paper breaks them, and they go on where it is smoothed."""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.tones import Layer
from ..masks.mask_parts import Labels, parts_of
from ..masks.skeleton import skeleton

_BLUR = 2.0
"""Pixels by which the ink is smoothed."""
_BROKEN, _LONGER, _ALL = 8, 1.1, 0.9
"""Lines in at least `_BROKEN` pieces are a pencil's if the longest one is at least `_LONGER` times
as long where the ink is smoothed, and all but letters together at least `_ALL` as long: of two
lines side by side, smoothed into one, half is left."""


def unbroken(marked: Booleans, of_smoothed: Callable[[], Booleans], shortest: float) -> Booleans:
    """Strokes (h, w), those of a pencil as they are `of_smoothed` ink. Where some are the
    `shortest` number of pixels long, others are letters."""
    if parts_of(marked, 8)[0] <= _BROKEN:
        return marked
    lengths, _ = stroke_lengths(marked)
    whole = of_smoothed()
    longer, _ = stroke_lengths(whole)
    if longer.max() < _LONGER * lengths.max():
        return marked
    if lengths.max() < shortest:
        shortest = 0
    before, after = (each[each >= shortest].sum() for each in (lengths, longer))
    return whole if after >= _ALL * before else marked


def stroke_lengths(marked: Booleans) -> tuple[NDArray[np.intp], Labels]:
    """How long each connected stroke (n,) is in pixels, 0 for what is none; their labels (h, w)."""
    count, parts = parts_of(marked, 8)
    lengths = np.bincount(parts[skeleton(marked)], minlength=count)
    lengths[0] = 0
    return lengths, parts


def smoothed(ink: Layer) -> Layer:
    """The ink (h, w) without the grain of paper."""
    return np.asarray(cv2.GaussianBlur(ink, (0, 0), _BLUR))
