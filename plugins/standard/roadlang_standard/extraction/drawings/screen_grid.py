"""The grid of a drawing program: thin lines from edge to edge at even spaces, behind what is drawn.

Drawn on a screen, it is exactly upright and has exact colors; that of a photographed sheet is found
in `ruling`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Booleans

from ..colors.counted_colors import color_codes, counted_colors
from ..colors.tones import Image, away_from, thinned

_GROUND, _SAMPLE = 0.4, 100_000
"""The ground has exactly one color on at least `_GROUND` of the picture, of which `_SAMPLE` pixels
are sampled."""
_COVERED, _THICKEST = 0.5, 3
"""A line of the grid is visible on more than `_COVERED` of its length, and at most `_THICKEST`
pixels thick."""
_FEWEST, _UNEVEN = 5, 1.01
"""A grid has at least `_FEWEST` lines, each within `_UNEVEN` pixels of a multiple of the usual
spacing."""
_PALE, _MANY, _WHOLE = 0.8, 10, 0.97
"""A grid has less than `_PALE` of the contrast of what is drawn. Darker lines may be streets unless
there are at least `_MANY`, visible on more than `_WHOLE` of their length."""
_MARGINS, _ACROSS = 2, 0.9
"""At most `_MARGINS` lines across those of ruled paper, each visible on more than `_ACROSS` of its
length from edge to edge, are its margins."""
_SAME = 3
"""Maximum difference in gray levels between a line of the grid and its pixels."""


@dataclass(frozen=True)
class _Lines:
    """Rows of the picture in which there are lines of a grid (n,), the color of each (n, 3), and
    the share of its length on which it has it (n,)."""

    rows: NDArray[np.intp]
    colors: NDArray[np.float64]
    shares: NDArray[np.float64]


def without_grid(image: Image) -> Image:
    """The picture (h, w, 3) with its ground in place of the grid; itself if it has none."""
    ground = _ground(image)
    if ground is None:
        return image
    away = away_from(image, ground)
    ways = [(image, away), (_turned(image), away.T)]
    printed = [_lines(*way) for way in ways]
    printed = [None if x is None or not _is_printed(x, ground, away) else x for x in printed]
    if printed[0] is None and printed[1] is None:
        return image
    lines, columns = (
        _margins(*way) if one is None else one for one, way in zip(printed, ways, strict=True)
    )
    cleaned = image if lines is None else _cleared(image, image, lines, ground)
    if columns is not None:
        cleaned = _turned(_cleared(_turned(cleaned), ways[1][0], columns, ground))
    return np.ascontiguousarray(cleaned)


def _turned(image: Image) -> Image:
    return np.transpose(image, (1, 0, 2))


def _ground(image: Image) -> NDArray[np.float64] | None:
    """The color that much of the picture has exactly."""
    found = counted_colors(color_codes(thinned(image, _SAMPLE)))
    most = int(np.argmax(found.counts))
    if found.counts[most] < _GROUND * found.counts.sum():
        return None
    return np.asarray(found.colors[most], float)


def _lines(image: Image, away: Image) -> _Lines | None:
    """The lines of a grid along the rows of a picture (h, w, 3), where `away` (h, w) is not 0."""
    runs = _thin_runs(away, _COVERED)
    if not _are_even(runs.mean(axis=1)):
        return None
    return _visible(image, away, runs, _COVERED)


def _margins(image: Image, away: Image) -> _Lines | None:
    """The margins along the rows of a picture (h, w, 3) whose columns are ruled, if it has any;
    `away` as for `_lines`."""
    runs = _thin_runs(away, _ACROSS)
    return _visible(image, away, runs, _ACROSS) if 0 < len(runs) <= _MARGINS else None


def _thin_runs(away: Image, least: float) -> NDArray[np.intp]:
    """The first row, and the one after the last (n, 2), of thin lines along rows where `away` from
    the ground (h, w) is not 0 on more than this share."""
    covered = np.count_nonzero(away, axis=1) > least * away.shape[1]
    edges = np.flatnonzero(np.diff(covered.view(np.int8), prepend=0, append=0))
    runs = edges.reshape(-1, 2)
    return runs[runs[:, 1] - runs[:, 0] <= _THICKEST]


def _visible(image: Image, away: Image, runs: NDArray[np.intp], least: float) -> _Lines | None:
    """The lines in these runs of rows that have one color on more than this share."""
    rows = np.concatenate([np.arange(*run) for run in runs.tolist()])
    colors = np.array([_usual_color(image[row], away[row] > 0) for row in rows])
    shares = np.array(
        [_has(image[row], color).mean() for row, color in zip(rows, colors, strict=True)]
    )
    kept = shares > least
    return _Lines(rows[kept], colors[kept], shares[kept]) if kept.any() else None


def _are_even(places: NDArray[np.float64]) -> bool:
    """Whether lines (n,) are so many and so evenly spaced as those of a grid."""
    if len(places) < _FEWEST:
        return False
    apart = np.diff(places)
    usual = float(np.median(apart))
    return bool((np.abs(apart - usual * np.maximum(1, np.round(apart / usual))) < _UNEVEN).all())


def _usual_color(row: Image, marked: Booleans) -> NDArray[np.float64]:
    """The most frequent color (3,) of what is `marked` (w,) in a row (w, 3)."""
    found = counted_colors(color_codes(row[None])[0][marked])
    return np.asarray(found.colors[int(np.argmax(found.counts))], float)


def _has(row: Image, color: NDArray[np.float64]) -> Booleans:
    """Which pixels (w,) of a row (w, 3) have a color."""
    return np.asarray((np.abs(row - color) <= _SAME).all(axis=1))


def _is_printed(lines: _Lines, ground: NDArray[np.float64], away: Image) -> bool:
    """Whether lines are behind what is drawn, or too many and too long for streets."""
    contrast = float(np.median(np.abs(lines.colors - ground).max(axis=1)))
    if contrast < _PALE * float(away.max()):
        return True
    return len(lines.rows) >= _MANY and float(np.median(lines.shares)) > _WHOLE


def _cleared(cleaned: Image, image: Image, lines: _Lines, ground: NDArray[np.float64]) -> Image:
    """A picture (h, w, 3) with the `ground` where the lines of another one are seen."""
    result = cleaned.copy()
    for row, color in zip(lines.rows.tolist(), lines.colors, strict=True):
        result[row][_has(image[row], color)] = ground
    return result
