"""A quick test that most moved lines pass: they are certain not to fold.

The exact tests of `roadlang.geometry.batches.folding` need the length of every step. Where the
least and the greatest of a row leave no doubt, products of the steps are enough.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Booleans, Floats
from ..numbers.row_blocks import blocks
from .folding import LEAST_ADVANCE, QUARTER_TURN

_DOUBT = 1e-9
"""Share by which a row passes at least, for what rounding may do to the exact tests."""


@dataclass(frozen=True)
class StepBounds:
    """The n steps of V lines from station to station."""

    east: Floats
    """(V, n) meters"""
    north: Floats
    """(V, n) meters"""
    longest: Floats
    """(V,) meters that no step is longer than"""

    @classmethod
    def of(cls, points: Floats, closed: bool) -> StepBounds:
        """`points`: (V, S, 2)."""
        parts, squares = [], np.zeros(len(points))
        for axis in (0, 1):
            line = points[..., axis]
            if closed:
                line = np.concatenate([line, line[:, :1]], axis=1)
            part = line[:, 1:] - line[:, :-1]
            most = np.maximum(part.max(axis=1), -part.min(axis=1))
            squares += most * most
            parts.append(part)
        return cls(parts[0], parts[1], np.sqrt(squares))

    def part(self, rows: slice) -> tuple[Floats, Floats]:
        """East and north of the steps of some lines; where there is but one line, of that."""
        return (
            (self.east, self.north) if len(self.east) == 1 else (self.east[rows], self.north[rows])
        )


def surely_smooth(
    steps: StepBounds, base: StepBounds, curvature: Floats, gaps: Floats, closed: bool
) -> Booleans:
    """(V,) True where the lines with these `steps`, which follow the V lines or the one line with
    the steps `base`, are certain to pass `fold_of_points` and `turns_too_much`. `curvature` (V, S);
    `gaps` (n,) of the stations.
    """
    found = np.zeros(len(curvature), dtype=bool)
    least, most = limits(gaps)
    longest = np.broadcast_to(base.longest, found.shape)
    for rows in blocks(curvature):
        own = steps.part(rows)
        advance = _products(own, base.part(rows)).min(axis=1, initial=np.inf)
        before, after = ((own[0][:, at], own[1][:, at]) for at in (slice(-1), slice(1, None)))
        onward = _products(before, after).min(axis=1, initial=np.inf)
        if closed:
            last, first = ((own[0][:, at], own[1][:, at]) for at in (slice(-1, None), slice(1)))
            onward = np.minimum(onward, _products(last, first)[:, 0])
        bend = np.maximum(curvature[rows].max(axis=1), -curvature[rows].min(axis=1))
        is_bent = bend * steps.longest[rows] >= most
        found[rows] = (advance > least * longest[rows]) & (onward > 0.0) & ~is_bent
    return found


def limits(gaps: Floats) -> tuple[float, float]:
    """The least advance of a line that is certain not to fold, for each meter of the longest step
    that it follows, meters; and the greatest turn over its longest step, radians. `gaps` (n,) of
    the stations."""
    return LEAST_ADVANCE * float(gaps.max()) * (1.0 + _DOUBT), (1.0 - _DOUBT) * QUARTER_TURN


def _products(a: tuple[Floats, Floats], b: tuple[Floats, Floats]) -> Floats:
    """Dot products, as `folding` has them to the last bit."""
    found = a[0] * b[0]
    found += a[1] * b[1]
    return found
