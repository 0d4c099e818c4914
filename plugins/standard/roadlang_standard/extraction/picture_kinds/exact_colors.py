"""Whether a picture was rendered: it has a few exact colors."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.overexposed import WHITE, is_overexposed
from ..colors.tones import Image, away_from, away_from_each, flatness, thinned
from ..maps.map_styles import style_of
from ..maps.map_tones import LOSSY, flat_colors
from .still_colors import has_few_still_colors, has_still_land

_SAMPLE = 250_000
"""Number of pixels that are sampled."""
_COLORS, _SAME, _OFF = 8, 5, 1.8
"""The `_COLORS` most frequent flat colors are considered. Pixels within `_SAME` gray levels of one
have that color; in a rendered picture their mean deviation is at most `_OFF`. Sky, sand, paper and
blurred parts of photos have little texture, but shades. Drawings stored as JPEG deviate by up to
1.7."""
_HALF = 0.5
"""Least share of a picture without shading that has one of these colors."""
_SEVERAL, _MOST, _MAP_OFF = 3, 0.6, 2.5
"""A map has at least `_SEVERAL` of these colors, on more than `_MOST` of it; with many houses,
stored as JPEG, the mean deviation is up to `_MAP_OFF`."""
_LEAST_FLAT = 0.2
"""Least share of a map without texture: sand, dunes and tiles may be near a few colors, but are
nowhere even. JPEG leaves 0.39 of a map full of houses."""
_SAME_SHARE, _SAME_IN_ALL, _WINDOW = 0.01, 0.4, 1024
"""A lossless picture has more than `_SEVERAL` colors exactly, each on more than `_SAME_SHARE` of
its middle (`_WINDOW` pixels a side), and together on more than `_SAME_IN_ALL`."""
_LAND, _PURE = 0.5, 5
"""Or it has one color exactly on more than `_LAND` of it, at least `_PURE` gray levels from black
and white."""
_SOME_LAND, _NEXT, _MOSTLY_FLAT = 0.35, 0.15, 0.55
"""Or it has one color exactly on more than `_SOME_LAND` of it, and the colors next to that on less
than `_NEXT` of that share: paper, and even parts of a photo, have those just as often. As a photo
may have a margin of one color, more than `_MOSTLY_FLAT` of the picture must be without texture."""
_EACH, _ALL, _TINTED = 0.03, 0.3, 5
"""Or it has several colors other than black and white exactly, each on more than `_EACH` of it and
together on more than `_ALL`, whose tints differ by more than `_TINTED` gray levels. Flat parts of a
photo of paper have hardly a hundredth of one color."""
_BLOCKS, _FILLED, _PRESENT, _EVEN, _NEAR = 4, 0.1, 12, 2.5, 7
"""One of the two most frequent colors (within `_NEAR` gray levels) covers more than `_FILLED` of at
least `_PRESENT` of 4 x 4 blocks, and its mean differs between blocks by at most `_EVEN` gray
levels: paper is never lit so evenly, and has another color in a shadow."""


def is_shaded(image: Image, within: Booleans | None = None) -> bool:
    """Whether most of a picture (h, w, 3), or of what is `within` (h, w), has none of a few exact
    colors."""
    small = image if within is not None else np.ascontiguousarray(thinned(image, _SAMPLE))
    share, off = _near(small, flat_colors(small)[:_COLORS], within)
    return share < _HALF or off > _OFF


def has_exact_colors(image: Image) -> bool:
    """Whether a picture (h, w, 3) has several exact colors, one of them everywhere: a rendered map,
    even one that was saved as JPEG and is full of houses."""
    part = _middle(image)
    found = flat_colors(part)[:_COLORS]
    if _is_lossless(part, found) or (
        _has_pure_land(part, found) and flatness(image) > _MOSTLY_FLAT
    ):
        return True
    if found and found[0].min() >= WHITE and is_overexposed(part):
        return False
    small = np.ascontiguousarray(thinned(image, _SAMPLE))
    colors = flat_colors(small)[:_COLORS]
    if len(colors) >= _SEVERAL:
        share, off = _near(small, colors)
        # Where the sea or a park has the most frequent color, the next one is the land's.
        is_even = any(_is_even(small, color) for color in colors[:2])
        if share > _MOST and off <= _MAP_OFF and is_even and flatness(image) > _LEAST_FLAT:
            return True
    if style_of(part, found, LOSSY) is not None:
        return True
    return len(found) > _SEVERAL and has_few_still_colors(part)


def has_exact_land(image: Image) -> bool:
    """Whether a picture (h, w, 3) of many edges has one or two exact colors everywhere: a map of
    black houses, or one as dark as its land, stored as JPEG."""
    return has_still_land(_middle(image))


def _middle(image: Image) -> Image:
    """The middle of a picture (h, w, 3), at most so many pixels a side."""
    if max(image.shape[:2]) <= _WINDOW:
        return np.ascontiguousarray(image)
    top, left = (max(0, size - _WINDOW) // 2 for size in image.shape[:2])
    return np.ascontiguousarray(image[top : top + _WINDOW, left : left + _WINDOW])


def _is_lossless(part: Image, colors: list[NDArray[np.float64]]) -> bool:
    """Whether several colors are exactly the same on many pixels, as no camera sees them. JPEG
    keeps some of these far from edges."""
    aways = away_from_each(part, colors)
    shares = [float(away.size - np.count_nonzero(away)) / away.size for away in aways]
    if sum(share > _SAME_SHARE for share in shares) > _SEVERAL and sum(shares) > _SAME_IN_ALL:
        return True
    # Margins without data are pure black or white.
    tinted = [
        (share, color)
        for share, color in zip(shares, colors, strict=True)
        if color.min() >= _PURE and color.max() <= 255 - _PURE
    ]
    if any(share > _LAND for share, _ in tinted):
        return True
    frequent = [(share, color - color.mean()) for share, color in tinted if share > _EACH]
    if sum(share for share, _ in frequent) <= _ALL:
        return False
    return float(np.ptp([tint for _, tint in frequent], axis=0).max()) > _TINTED


def _has_pure_land(part: Image, colors: list[NDArray[np.float64]]) -> bool:
    """Whether much of a picture has exactly one color, and hardly anything has one next to that:
    JPEG keeps an even land so."""
    for color in colors[:1]:
        away = away_from(part, color)
        same, beside = float((away == 0).mean()), float((away == 1).mean())
        tinted = color.min() >= _PURE and color.max() <= 255 - _PURE
        return bool(tinted and same > _SOME_LAND and beside < _NEXT * same)
    return False


def _near(
    image: Image, colors: list[NDArray[np.float64]], within: Booleans | None = None
) -> tuple[float, float]:
    """The share of pixels that have one of the colors, and how far these are off it."""
    off = np.full(image.shape[:2], 255, np.uint8)
    for away in away_from_each(image, colors):
        off = np.minimum(off, away)
    off = off if within is None else off[within]
    near = off <= _SAME
    return float(near.mean()), float(off[near].mean()) if near.any() else 255.0


def _is_even(image: Image, color: NDArray[np.float64]) -> bool:
    """Whether a color is the same in all parts of a picture."""
    near = (away_from(image, color) <= _NEAR).astype(np.uint8)
    rows, columns = (np.linspace(0, size, _BLOCKS + 1).astype(int) for size in image.shape[:2])
    means = [
        cv2.mean(image[top:bottom, left:right], near[top:bottom, left:right])[:3]
        for top, bottom in pairwise(rows)
        for left, right in pairwise(columns)
        if bottom > top and right > left and near[top:bottom, left:right].mean() > _FILLED
    ]
    return len(means) >= _PRESENT and bool(np.ptp(np.array(means), axis=0).max() <= _EVEN)
