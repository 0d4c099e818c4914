"""The colors of the still parts of a picture: JPEG leaves the even areas of a map still."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.counted_colors import color_codes, counted_colors
from ..colors.local_spread import local_spread
from ..colors.tones import Image, away_from

_STILL, _STILLS = 1, 0.03
"""Pixels are still if their 3 x 3 neighborhood varies by at most `_STILL` gray levels. JPEG leaves
more than `_STILLS` of a map still, away from edges."""
_ALIKE, _APART, _COVERED, _PART, _PARTS, _MOST = 2, 5, 0.72, 0.005, 4, 8
"""More than `_COVERED` of the still pixels of a map are within `_ALIKE` gray levels of one of its
`_MOST` most frequent colors. Pixels farther off, up to `_APART`, are shades of it, as paper and sky
have, and count for no color. At least `_PARTS` colors have more than `_PART` each: a folded sheet
has three shades."""
_NEARLY_ALL, _LAND, _PURE = 0.96, 0.1, 5
"""Two colors, each on more than `_LAND` of the still pixels, make up more than `_NEARLY_ALL` of
these; one alone is at least `_PURE` gray levels from black and white, which margins of photos and
overexposed parts are as well."""
_BLOCKS, _FILLED, _PRESENT = 4, 0.1, 12
"""They are everywhere: on more than `_FILLED` of at least `_PRESENT` of 4 x 4 blocks."""


def has_few_still_colors(image: Image) -> bool:
    """Whether what is still in a picture (h, w, 3) has a few colors, and not the shades between
    them: a map stored as JPEG, whatever lies on its land."""
    found = _frequent(image, local_spread(image) <= _STILL)
    return (
        sum(share for _, share in found) > _COVERED
        and sum(share > _PART for _, share in found) >= _PARTS
    )


def has_still_land(image: Image) -> bool:
    """Whether nearly all that is still in a picture (h, w, 3) has one or two exact colors, and that
    everywhere: the land of a map stored as JPEG, and its houses, though most of the map is lines.

    A photo has a still sky, margin or shadow, but not in all of its parts.
    """
    still = local_spread(image) <= _STILL
    land = [(color, share) for color, share in _frequent(image, still)[:2] if share > _LAND]
    if sum(share for _, share in land) <= _NEARLY_ALL:
        return False
    if len(land) == 1 and not _PURE <= land[0][0].min() <= land[0][0].max() <= 255 - _PURE:
        return False
    even = still & np.logical_or.reduce([away_from(image, color) <= _ALIKE for color, _ in land])
    rows, columns = (np.linspace(0, size, _BLOCKS + 1).astype(int) for size in even.shape)
    filled = [
        even[top:bottom, left:right].mean() > _FILLED
        for top, bottom in pairwise(rows)
        for left, right in pairwise(columns)
        if bottom > top and right > left
    ]
    return int(np.count_nonzero(filled)) >= _PRESENT


def _frequent(image: Image, still: Booleans) -> list[tuple[NDArray[np.float64], float]]:
    """The most frequent colors (3,) of the still pixels (h, w) of a picture (h, w, 3), and their
    shares of these; none if hardly anything is still."""
    if still.mean() < _STILLS:
        return []
    counted = counted_colors(color_codes(image[still][None]))
    left = np.ones(len(counted.colors), bool)
    found: list[tuple[NDArray[np.float64], float]] = []
    for peak in np.argsort(counted.counts, kind="stable")[::-1]:
        if len(found) == _MOST:
            break
        if left[peak]:
            color = counted.colors[peak].astype(float)
            share = counted.number(left & counted.near(color, _ALIKE)) / still.sum()
            found.append((color, float(share)))
            left &= ~counted.near(color, _APART)
    return sorted(found, key=lambda one: -one[1])
