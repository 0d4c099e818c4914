"""A quick test that most moved lines pass: they are certain not to fold.

The exact tests of `roadlang.geometry.folding` need the length of every step. Where the least and
the greatest of a row leave no doubt, products of the steps are enough.
"""

from __future__ import annotations

import numpy as np

from .arrays import Booleans, Floats
from .folding import LEAST_ADVANCE, QUARTER_TURN
from .row_blocks import blocks

_DOUBT = 1e-9
"""Share by which a row passes at least, for what rounding may do to the exact tests."""


def surely_smooth(
    points: Floats, base: Floats, curvature: Floats, gaps: Floats, closed: bool
) -> Booleans:
    """(V,) True where the lines `points` (V, S, 2), which follow `base` (V or 1, S, 2), are certain
    to pass `fold_of_points` and `turns_too_much`. `curvature` (V, S); `gaps` (n,) of the stations.
    """
    found = np.zeros(len(points), dtype=bool)
    least = LEAST_ADVANCE * float(gaps.max()) * (1.0 + _DOUBT)
    most = (1.0 - _DOUBT) * QUARTER_TURN
    for rows in blocks(curvature):
        steps, length = _steps(points[rows], closed)
        along, longest = _steps(base if len(base) == 1 else base[rows], closed)
        advance = _products(steps, along).min(axis=1, initial=np.inf)
        before, after = ([part[:, at] for part in steps] for at in (slice(-1), slice(1, None)))
        onward = _products(before, after).min(axis=1, initial=np.inf)
        if closed:
            onward = np.minimum(onward, _products(*_seam(steps))[:, 0])
        bend = np.maximum(curvature[rows].max(axis=1), -curvature[rows].min(axis=1))
        found[rows] = (advance > least * longest) & (onward > 0.0) & (bend * length < most)
    return found


def _steps(points: Floats, closed: bool) -> tuple[list[Floats], Floats]:
    """East and north, (V, n) each, and (V,) what no step is longer than."""
    steps, squares = [], np.zeros(len(points))
    for axis in (0, 1):
        line = points[..., axis]
        if closed:
            line = np.concatenate([line, line[:, :1]], axis=1)
        part = line[:, 1:] - line[:, :-1]
        most = np.maximum(part.max(axis=1), -part.min(axis=1))
        squares += most * most
        steps.append(part)
    return steps, np.sqrt(squares)


def _seam(steps: list[Floats]) -> tuple[list[Floats], list[Floats]]:
    """The last steps of closed lines, and the first."""
    return [part[:, -1:] for part in steps], [part[:, :1] for part in steps]


def _products(a: list[Floats], b: list[Floats]) -> Floats:
    """Dot products, as `folding` has them to the last bit."""
    found = a[0] * b[0]
    found += a[1] * b[1]
    return found
