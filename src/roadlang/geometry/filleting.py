"""Curves joined end to end, their corners rounded."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from .arrays import norm
from .curve import Curve
from .errors import GeometryError
from .spline import PiecewiseCubic, hermite

_LARGEST_SHARE = 0.45
_STRAIGHT = 1e-9


def chained(curves: Sequence[Curve], rounding: float) -> Curve:
    """One open curve along `curves`, each of which starts where the one before it ends.

    Where the heading jumps, up to `rounding` meters on both sides (at most 45 % of a curve) give
    way to a smooth bend; everything else stays exactly as it was.
    """
    if not curves:
        raise GeometryError("there is no curve to join")
    corners = [_is_corner(a, b) for a, b in pairwise(curves)]
    parts: list[PiecewiseCubic] = []
    previous: Curve | None = None
    for index, curve in enumerate(curves):
        reach = min(rounding, _LARGEST_SHARE * curve.length)
        start = reach if index > 0 and corners[index - 1] else 0.0
        stop = curve.length - (reach if index < len(corners) and corners[index] else 0.0)
        kept = curve if stop - start >= curve.length else curve.between(start, stop)
        if previous is not None and start > 0.0:
            parts.append(_bend(previous, kept))
        parts.append(kept.spline)
        previous = kept
    spline = _concatenated(parts)
    points = np.concatenate([spline.coefficients[:, 0], curves[-1].points[-1:]])
    return Curve(spline, False, points)


def _is_corner(before: Curve, after: Curve) -> bool:
    gap = float(norm(after.points[0] - before.points[-1]))
    if gap > 1e-3 * min(before.length, after.length):
        raise GeometryError(f"curves to join are {gap:.3g} m apart")
    arriving, leaving = before.tangent(before.length), after.tangent(0.0)
    return float(norm(arriving - leaving)) > _STRAIGHT


def _bend(before: Curve, after: Curve) -> PiecewiseCubic:
    ends = np.stack([before.points[-1], after.points[0]])
    headings = np.array([before.heading(before.length), after.heading(0.0)])
    return hermite(ends, headings, closed=False)


def _concatenated(parts: Sequence[PiecewiseCubic]) -> PiecewiseCubic:
    offset, knots = 0.0, [np.zeros(1)]
    for part in parts:
        local = part.knots - part.knots[0]
        knots.append(offset + local[1:])
        offset += float(local[-1])
    return PiecewiseCubic(
        np.concatenate(knots), np.concatenate([part.coefficients for part in parts])
    )
