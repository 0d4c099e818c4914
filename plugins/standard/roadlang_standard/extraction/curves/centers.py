"""Where the middle of a road is, beside a line along it, and where that can be trusted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter, minimum_filter1d

from roadlang.geometry import Booleans, Floats

from ..colors.fast_median import median
from .edges import CenterLine, across, normals_in_a_row, sides_of

Layer = NDArray[np.float32]
_THIN = 5.0
"""The middle of strokes thinner than this, in pixels, is the centroid of their ink."""
_STEP = 0.25


def centers(
    lines: Sequence[CenterLine], surface: Layer, width: float, level: float
) -> list[tuple[Floats, Booleans]]:
    """Of each line, pixels (n,) from its points, about one apart, to the middle of the road, along
    `normals`; and whether the road is as wide there as around: not so at junctions, corners and
    ends."""
    if width < _THIN:
        return [_steady(*each, width) for each in _centroids(lines, surface, width)]
    found = sides_of(lines, surface, 1.1 * width + 3, level)
    return [_steady((s.left - s.right) / 2, s.left + s.right, width) for s in found]


def _steady(offset: Floats, wide: Floats, width: float) -> tuple[Floats, Booleans]:
    """The offsets (n,), 0 where the road is not as wide (n,) as around, and where it is."""
    known = np.isfinite(wide)
    if not known.any():
        return np.zeros(len(offset)), known
    typical = median(wide[known])
    around = median_filter(np.where(known, wide, typical), int(4 * width) + 41, mode="nearest")
    even = known & (np.abs(np.where(known, wide, 0) - around) < _unevenness(around))
    even &= np.abs(around - typical) < 0.5 * typical
    even = minimum_filter1d(even.astype(np.uint8), 2 * int(0.25 * width + 2) + 1) > 0
    even = _without_short_runs(even, 0.5 * width + 4)
    return np.where(even, offset, 0.0), even


def _unevenness(width: Floats) -> Floats:
    """By how many pixels the measured width of an even stroke varies: by those at its edges."""
    return np.maximum(np.minimum(0.5 + 0.1 * width, 0.9), 0.08 * width)


def _without_short_runs(flags: Booleans, least: float) -> Booleans:
    """Only those that are set so many times in a row; chance has it so in a junction's middle."""
    padded = np.zeros(len(flags) + 2, np.int8)
    padded[1:-1] = flags
    edges = np.flatnonzero(padded[1:] != padded[:-1])
    begins, lengths = edges[::2], edges[1::2] - edges[::2]
    kept = np.zeros(len(flags), bool)
    for begin, length in zip(begins.tolist(), lengths.tolist(), strict=True):
        kept[begin : begin + length] = length >= least
    return kept


def _centroids(
    lines: Sequence[CenterLine], surface: Layer, width: float
) -> Iterator[tuple[Floats, Floats]]:
    """Of the ink across each line, and how much of it there is, NaN without any."""
    away = np.arange(-(width / 2 + 2), width / 2 + 2 + _STEP, _STEP)
    points = np.concatenate([line.points for line in lines])
    every = across(points, normals_in_a_row(points, lines), away, surface).astype(float)
    first = 0
    for line in lines:
        ink = every[first : first + len(line.points)]
        first += len(line.points)
        total = ink.sum(axis=1)
        there = total * _STEP > 0.3
        yield (ink @ away) / np.maximum(total, 1e-9), np.where(there, total * _STEP, np.nan)
