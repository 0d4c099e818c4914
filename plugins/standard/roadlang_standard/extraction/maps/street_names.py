"""Streets beneath their names: a map writes a name along its street, and never beyond its end."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.fast_median import median
from ..masks.mask_parts import parts_and_boxes
from .joined_names import lines_of_letters

_LOWEST, _TALLEST, _LONG = 9.0, 24.0, 3.0
"""A name on one line is `_LOWEST` to `_TALLEST` pixels tall, and at least `_LONG` times as long:
the dashes of a footpath are lower."""
_CURVED = 5.0
"""A name longer than this many times its height may be curved."""
_REACH, _LEAST_REACH = 3.0, 12.0
"""Beyond its name, a street continues for `_REACH` widths and at least `_LEAST_REACH` pixels,
..."""
_MOSTLY = 0.75
"""visible on at least this share of that length, ..."""
_ASIDE, _TURN = 2.5, 0.25
"""with a lateral offset of at most `_ASIDE` pixels, plus `_TURN` pixels for each pixel of the
way."""
_BAND = 0.3
"""The pixels of a name are on average no more of its height off its middle: of a band, a quarter.
"""
_HIDES = 1.5
"""A name more than this many times as tall as the street is wide hides the street."""
_STRAIGHT, _BENT, _ONE_WAY = 0.6, 1.8, 0.7
"""The middle line of a name turns by at most `_STRAIGHT` radians in total, or by at most `_BENT`
if at least `_ONE_WAY` of that is to one side. Other lines run through words that stand side by
side."""
_ROUNDS, _DEGREE = 3, 4
"""A curved middle line is fitted in `_ROUNDS` rounds by polynomials of degree `_DEGREE` in its
length."""
_LEVEL, _LEVEL_JOINED, _EXACTLY = 0.1, 0.2, 1.5
"""A name is level if its middle line rises by less than `_LEVEL` pixels per piece, or by less than
`_LEVEL_JOINED` if it is one of several that touch: the names of two shops are not written on one
line. A street that continues at only one of its ends must then be within `_EXACTLY` pixels of the
middle line."""
_INSET = 2
"""Margin around marked letters, in pixels."""


_PIECE, _OFF, _REFITS, _ONE_LINE = 4.0, 0.6, 4, 17.0
"""Where corners of houses touch a name, pixels more than `_OFF` of its height off its middle line
are theirs. Its height is the median of pieces `_PIECE` pixels long; the line is fitted to the
middles of these, `_REFITS` times. Two lines of text look like one with houses beside it: what is
left is to be at most `_ONE_LINE` pixels tall."""


@dataclass(frozen=True)
class _Name:
    """The middle line (n, 2) of a name, in pixels from end to end, its height, and its pixels
    (m, 2)."""

    line: NDArray[np.float64]
    height: float
    points: NDArray[np.float64]


def streets_below_names(
    mask: Booleans, letters: Booleans, width: float
) -> tuple[Booleans, Booleans]:
    """The streets (h, w) that names cover, and the names (h, w) that hide theirs.

    A name among the `letters` (h, w) is along a street of the roads `mask` (h, w) that leads on
    from either of its ends; it then covers the street from end to end. `width` is that of most
    streets, pixels.
    """
    count, words, stats = parts_and_boxes(letters)
    drawn = np.zeros(mask.shape, np.uint8)
    named = np.zeros(mask.shape, bool)
    for word in range(1, count):
        left, top, wide, tall, area = (int(value) for value in stats[word])
        if max(wide, tall) < _LONG * np.sqrt(area / _LONG):
            continue
        window = (slice(top, top + tall), slice(left, left + wide))
        y, x = np.nonzero(words[window] == word)
        points = np.stack([x + left, y + top], axis=1).astype(np.float64)
        for name, line in _streets(mask, points, width):
            street = np.round(line * 16).astype(np.int32)
            cv2.polylines(drawn, [street], False, 1, max(1, round(width)), cv2.LINE_8, 4)
            if name.height > _HIDES * width:
                named[tuple(name.points.astype(np.intp).T[::-1])] = True
    return np.asarray(drawn > 0), named


def _streets(
    mask: Booleans, points: NDArray[np.float64], width: float
) -> Iterator[tuple[_Name, NDArray[np.float64]]]:
    """The names among connected letters (n, 2), and the line (m, 2) of the street below each."""
    rest = points
    for pixels in (points, _without_houses(points)):
        name = _name(pixels)
        line = None if name is None else _street(mask, name, width, _LEVEL)
        if name is not None and line is not None:
            yield name, line
        if name is not None:
            rest = _others(rest, pixels)
        if line is not None:
            break
    # Where the names of two streets touch at a corner, they are no one line.
    for pixels in lines_of_letters(rest):
        name = _name(pixels)
        line = None if name is None else _street(mask, name, width, _LEVEL_JOINED)
        if name is not None and line is not None and name.height <= _ONE_LINE:
            yield name, line


def _others(points: NDArray[np.float64], some: NDArray[np.float64]) -> NDArray[np.float64]:
    """The pixels (n, 2) that are none of some others (m, 2)."""
    code, other = (pixels.astype(np.int64) @ (1 << 32, 1) for pixels in (points, some))
    return points[~np.isin(code, other)]


def _axes(
    points: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """The middle (2,) of pixels (n, 2), and the directions (2,) along and across them."""
    middle = points.mean(axis=0)
    across_all, mixed, down_all = np.cov((points - middle).T)[[0, 0, 1], [0, 1, 1]]
    angle = np.arctan2(2 * mixed, across_all - down_all) / 2
    along = np.array([np.cos(angle), np.sin(angle)])
    return middle, along, np.array([-along[1], along[0]])


def _without_houses(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """The pixels (n, 2) of a name without those of houses that touch its side; none if it is not
    written on one line."""
    kept, height = points, np.inf
    for _ in range(_REFITS):
        if len(kept) < _LOWEST:
            return kept[:0]
        middle, along, across = _axes(kept)
        u, v = (points - middle) @ along, (points - middle) @ across
        piece = np.floor((u - u.min()) / _PIECE).astype(np.intp)
        counts = np.bincount(piece)
        full = np.flatnonzero(counts)
        height = median(counts[full]) / _PIECE
        medians = v[np.lexsort((v, piece))][(np.cumsum(counts) - (counts + 1) // 2)[full]]
        kept = points[np.abs(v - _bend(full, medians)(piece)) <= _OFF * height]
    return kept if height <= _ONE_LINE else kept[:0]


def _bend(places: NDArray[np.intp], middles: NDArray[np.float64]) -> np.polynomial.Polynomial:
    """The curve through most of the middles (n,) of pieces: those of houses are far off."""
    degree = min(3, max(1, len(places) - 1))
    bend = np.polynomial.Polynomial.fit(places, middles, degree)
    weights = 1 / np.maximum(np.abs(middles - bend(places)), 1.0)
    return np.polynomial.Polynomial.fit(places, middles, degree, w=weights)


def _name(points: NDArray[np.float64]) -> _Name | None:
    """The middle line of the pixels (n, 2) of a word; None if it is none, or in several lines."""
    if not len(points):
        return None
    middle, along, across = _axes(points)
    u, v = (points - middle) @ along, (points - middle) @ across
    start, end = float(u.min()) + _INSET, float(u.max()) - _INSET
    height = len(points) / (end - start + 2 * _INSET)
    if not _LOWEST <= height <= _TALLEST or end - start < _LONG * height:
        return None
    degree = 3 if end - start > _CURVED * height else 1
    bend = np.polynomial.Polynomial.fit(u, v, degree)
    places = np.linspace(start, end, max(2, round((end - start) / 4)))
    line = middle + places[:, None] * along + bend(places)[:, None] * across
    for _ in range(_ROUNDS):
        away = _distances(points, line).min(axis=1)
        if away.mean() <= _BAND * height:
            return _Name(line, height, points) if _bends_once(line) else None
        line = _nearer(line, points)
    return None


def _bends_once(line: NDArray[np.float64]) -> bool:
    """Whether a line (n, 2) turns little, and mostly to one side, as names do."""
    steps = np.diff(line, axis=0)
    turns = np.diff(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0])))
    total = float(np.abs(turns).sum())
    return total <= _STRAIGHT or (total <= _BENT and abs(float(turns.sum())) >= _ONE_WAY * total)


def _nearer(line: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """A line (n, 2) moved to the middle of the pixels (m, 2) of a name that may bend much."""
    nearest = _distances(points, line).argmin(axis=1)
    fits = [np.polynomial.Polynomial.fit(nearest, points[:, axis], _DEGREE) for axis in (0, 1)]
    places = np.arange(len(line))
    return np.stack([fit(places) for fit in fits], axis=1)


def _distances(points: NDArray[np.float64], line: NDArray[np.float64]) -> NDArray[np.float64]:
    """The distance (m, n) of each pixel (m, 2) from each point of a line (n, 2)."""
    x, y = (points[:, axis, None] - line[:, axis] for axis in (0, 1))
    x *= x
    y *= y
    x += y
    return np.sqrt(x, out=x)


def _street(mask: Booleans, name: _Name, width: float, most: float) -> NDArray[np.float64] | None:
    """The line of the street (n, 2) below a name, which is level if it rises by less than `most`
    pixels per piece; None if none leads on from it."""
    first, last = (_leads_on(mask, line, width) for line in (name.line[::-1], name.line))
    # The first end was looked at backward.
    known = [offset for offset in (first if first is None else -first, last) if offset is not None]
    if not known:
        return None
    # Names of places are level: by chance a street may lead up to one of their ends.
    level = np.ptp(name.line[:, 1]) < most * len(name.line)
    if level and len(known) == 1 and abs(known[0]) > _EXACTLY:
        return None
    steps = np.gradient(name.line, axis=0)
    steps /= np.maximum(np.linalg.norm(steps, axis=1, keepdims=True), 1e-9)
    normals = np.stack([-steps[:, 1], steps[:, 0]], axis=1)
    line = name.line + np.linspace(known[0], known[-1], len(steps))[:, None] * normals
    ahead = [line[:1] - 4 * steps[:1]] if first is not None else []
    after = [line[-1:] + 4 * steps[-1:]] if last is not None else []
    return np.vstack([*ahead, line, *after])


def _leads_on(mask: Booleans, line: NDArray[np.float64], width: float) -> float | None:
    """How far to the left a street leads on from the last point of a line (n, 2), pixels; None if
    none does."""
    step = line[-1] - line[-min(4, len(line))]
    step /= max(float(np.linalg.norm(step)), 1e-9)
    normal = np.array([-step[1], step[0]])
    reach = np.arange(1, max(_REACH * width, _LEAST_REACH) + 4)
    aside = np.arange(-12, 13)
    there = line[-1] + reach[:, None, None] * step + aside[None, :, None] * normal
    column, row = np.round(there).astype(np.intp).transpose(2, 0, 1)
    height, across = mask.shape
    inside = (column >= 0) & (column < across) & (row >= 0) & (row < height)
    if inside[:, len(aside) // 2].sum() < _LEAST_REACH / 2:
        return None
    seen = inside & mask[np.clip(row, 0, height - 1), np.clip(column, 0, across - 1)]
    near = np.abs(aside)[None, :] <= _ASIDE + _TURN * reach[:, None]
    there_on = (seen & near).any(axis=1)
    valid = inside[:, len(aside) // 2]
    if there_on[3:][valid[3:]].mean() < _MOSTLY:
        return None
    # What is far wider is a street that crosses, or a square.
    if np.median(seen.sum(axis=1)[there_on]) > 2 * width + 4:
        return None
    rows, columns = np.nonzero(seen & near)
    early = reach[rows] <= reach[-1] / 2
    off = float(np.mean(aside[columns[early]] if early.any() else aside[columns]))
    return off if abs(off) <= _ASIDE else None
