"""Whether a picture was rendered: it has a few exact colors."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from .counted_colors import color_codes, counted_colors
from .map_tones import flat_colors, local_spread
from .tones import Image, away_from, flatness, thinned

_SAMPLE = 250_000
"""Pixels that are looked at."""
_COLORS, _SAME, _OFF = 8, 5, 1.8
"""So many colors are looked at; pixels within so many gray levels have one of them, and are off it
by less on average: the sky, sand, paper and what is out of focus in a photo have little texture,
but shades. Drawings stored as JPEG are off by up to 1.7."""
_HALF = 0.5
"""What is not shaded has these colors on at least this share of its pixels."""
_SEVERAL, _MOST, _MAP_OFF = 3, 0.6, 2.5
"""A map has at least so many of them, on more than this share, and where it is full of houses and
stored as JPEG is off them by up to this."""
_LEAST_FLAT = 0.2
"""Share of its pixels without texture: sand, dunes and tiles may be near a few colors, but are not
even anywhere. JPEG leaves .39 of a map full of houses."""
_SAME_SHARE, _SAME_IN_ALL, _WINDOW = 0.01, 0.4, 1024
"""A lossless picture has each of more colors exactly, on more than this share of its middle, of
so many pixels a side, and all of them on more than the other share."""
_LAND, _PURE = 0.5, 5
"""Or it has one exactly on more than this share, which is off black and white by so much."""
_SOME_LAND, _NEXT, _MOSTLY_FLAT = 0.35, 0.15, 0.55
"""Or one exactly on more than the first share, but the colors next to it on less than the second
share of that: paper, and what is even in a photo, has these just as often, but may have a margin of
one color. A map has no texture on more than the third share."""
_EACH, _ALL, _TINTED = 0.03, 0.3, 5
"""Or some that are off black and white, each on more than the first share and all of them on more
than the second, and no shades of one color, but so many gray levels off those: what is flat in a
photo of paper has hardly a hundredth of one color."""
_BLOCKS, _FILLED, _PRESENT, _EVEN, _NEAR = 4, 0.1, 12, 2.5, 7
"""Of 4 x 4 blocks, one of the two most frequent colors has a tenth of the area of at least 12
(paper has another color in a shadow), and is the same in each, within so many gray levels (pixels
within 7): paper is never lit so evenly."""
_STILL, _STILLS = 1, 0.03
"""What varies by no more gray levels within 3 x 3 pixels is still; JPEG leaves it so far from edges
of a map, on more than this share of it."""
_ALIKE, _APART, _COVERED, _PART, _PARTS = 2, 5, 0.72, 0.005, 4
"""Still pixels have a color within the first of so many gray levels, and none of the shades within
the second one, which paper and sky have: on this share of them, and on so much each of at least so
many colors: a folded sheet has three shades."""


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
        _has_exact_land(part, found) and flatness(image) > _MOSTLY_FLAT
    ):
        return True
    small = np.ascontiguousarray(thinned(image, _SAMPLE))
    colors = flat_colors(small)[:_COLORS]
    if len(colors) >= _SEVERAL:
        share, off = _near(small, colors)
        # Where the sea or a park has the most frequent color, the next one is the land's.
        is_even = any(_is_even(small, color) for color in colors[:2])
        if share > _MOST and off <= _MAP_OFF and is_even and flatness(image) > _LEAST_FLAT:
            return True
    return len(found) >= _PARTS and _has_few_still_colors(part)


def _has_few_still_colors(part: Image) -> bool:
    """Whether what is still in a picture (h, w, 3) has a few colors, and not the shades between
    them: a map stored as JPEG, whatever lies on its land."""
    still = local_spread(part) <= _STILL
    if still.mean() < _STILLS:
        return False
    counted = counted_colors(color_codes(part[still][None]))
    left = np.ones(len(counted.colors), bool)
    shares: list[float] = []
    for peak in np.argsort(counted.counts, kind="stable")[::-1]:
        if len(shares) == _COLORS:
            break
        if left[peak]:
            color = counted.colors[peak].astype(float)
            shares.append(counted.number(left & counted.near(color, _ALIKE)) / still.sum())
            left &= ~counted.near(color, _APART)
    return sum(shares) > _COVERED and sum(share > _PART for share in shares) >= _PARTS


def _middle(image: Image) -> Image:
    """The middle of a picture (h, w, 3), at most so many pixels a side."""
    top, left = (max(0, size - _WINDOW) // 2 for size in image.shape[:2])
    return np.ascontiguousarray(image[top : top + _WINDOW, left : left + _WINDOW])


def _is_lossless(part: Image, colors: list[NDArray[np.float64]]) -> bool:
    """Whether several colors are exactly the same on many pixels, as no camera sees them. JPEG
    keeps some of these far from edges."""
    shares = [float((away_from(part, color) == 0).mean()) for color in colors]
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


def _has_exact_land(part: Image, colors: list[NDArray[np.float64]]) -> bool:
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
    for color in colors:
        off = np.minimum(off, away_from(image, color))
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
