"""Curves and straight lines joined end to end, their corners rounded."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from ..arrays import Floats, cross, norm
from ..errors import GeometryError
from .curve import Curve, distinct_points
from .segments import Arc, Straight, chain
from .spline import PiecewiseCubic, hermite

_LARGEST_SHARE = 0.45
_STRAIGHT = 1e-9
_SHORTEST = 1e-6
"""Meters of a line or an arc."""
_SHORTEST_SHARE = 1e-9
"""The same as a share of the extent, below which a curve has points that coincide."""
_SHARPEST = np.radians(179.0)


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
        cut = min(rounding, _LARGEST_SHARE * curve.length)
        start = cut if index > 0 and corners[index - 1] else 0.0
        stop = curve.length - (cut if index < len(corners) and corners[index] else 0.0)
        middle = curve if stop - start >= curve.length else curve.between(start, stop)
        if previous is not None and start > 0.0:
            parts.append(_bend(previous, middle))
        parts.append(middle.spline)
        previous = middle
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


def _cut_corners(
    corners: Floats, radius: float, closed: bool
) -> tuple[Floats, Floats, Floats, float]:
    """(n, 2) the lines between corners; the turn at each corner between them; how much of both
    lines its fillet takes, 0 where that is less than the last number, meters."""
    ring = np.concatenate([corners, corners[:2]]) if closed else corners
    legs = np.diff(ring, axis=0)
    lengths = norm(legs)
    turns = np.arctan2(cross(legs[:-1], legs[1:]), (legs[:-1] * legs[1:]).sum(axis=1))
    shorter = np.minimum(lengths[:-1], lengths[1:]) / 2.0
    cuts = np.minimum(radius * np.tan(np.abs(turns) / 2.0), shorter)
    shortest = max(_SHORTEST, _SHORTEST_SHARE * float(norm(np.ptp(corners, axis=0))))
    return legs, turns, np.where(cuts < shortest, 0.0, cuts), shortest


def filleted(points: ArrayLike, radius: float, closed: bool = False) -> Curve:
    """Straight lines through `points` (n, 2), meters, their corners rounded by arcs of `radius`.

    A fillet takes at most half of the shorter line at its corner, so that its radius may be less.
    A closed curve begins after the fillet at the first point. Raises GeometryError as
    `Curve.through` does, for a radius that is not positive, and where the lines turn right back.
    """
    if not 0.0 < radius < np.inf:
        raise GeometryError("the radius of a fillet must be positive")
    corners = distinct_points(points, closed)
    legs, turns, cuts, shortest = _cut_corners(corners, radius, closed)
    # A turn that is too slight for a fillet would be lost, and the end would lie elsewhere.
    while (lost := (cuts == 0.0) & (turns != 0.0)).any() and len(corners) > (3 if closed else 2):
        first = np.flatnonzero(lost)[::2][: len(corners) - (3 if closed else 2)]
        corners = np.delete(corners, (first + 1) % len(corners), axis=0)
        legs, turns, cuts, shortest = _cut_corners(corners, radius, closed)
    lengths, tangents = norm(legs), np.tan(np.abs(turns) / 2.0)
    if (np.abs(turns) > _SHARPEST).any():
        place = corners[(int(np.argmax(np.abs(turns))) + 1) % len(corners)]
        raise GeometryError(f"the lines turn right back at ({place[0]:g} m, {place[1]:g} m)")
    if closed:  # the last corner is that at the first point
        legs, lengths = legs[:-1], lengths[:-1]
        before, after = np.roll(cuts, 1), cuts
        start = corners[0] + legs[0] / lengths[0] * before[0]
    else:
        before, after = np.concatenate([[0.0], cuts]), np.concatenate([cuts, [0.0]])
        start = corners[0]
    pieces: list[Straight | Arc] = []
    for index, length in enumerate(lengths):
        rest = float(length - before[index] - after[index])
        if rest > shortest:
            pieces.append(Straight(rest))
        if index < len(turns) and cuts[index] > 0.0:
            pieces.append(Arc(float(cuts[index] / tangents[index]), float(turns[index])))
    heading = float(np.arctan2(legs[0, 1], legs[0, 0]))
    return chain(pieces, start, heading, spacing=0.5).curve(closed)
