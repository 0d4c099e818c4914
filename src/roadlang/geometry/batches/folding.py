"""Whether a displaced road runs backwards, or bends more sharply than its stations can show.

A displacement of a bend toward its inside shortens it; at the center of the bend it has no length,
and beyond it runs backwards. A road is *folded* where

- `1 - k e` is less than `LEAST_ADVANCE` at a station (curvature k, displacement e), or a step
  from one station to the next advances along the road that it was made from by less than that
  share of their gap, or
- it turns by a quarter turn or more from one step to the next, or would do so by its curvature.

So a step of a road that is not folded has at least 5 % of the gap of its stations, and its
curvature is less than a quarter turn over the mean length of two steps: pi / (0.1 gap), 31/m for
stations a meter apart. All tests work on many rows at once.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Booleans, Floats, SharedArrays, cross, left_of, norm
from ..numbers.differences import are_even
from .fold_bounds import Extremes, FoldBounds

LEAST_ADVANCE = 0.05
"""Share of the gap between stations that is left of every step of a road that is not folded."""

QUARTER_TURN = np.pi / 2.0


def fold_of_points(
    points: Floats, gaps: Floats, closed: bool, base: tuple[Floats, Floats] | None = None
) -> Booleans:
    """(V,) True where the lines `points` (V, S, 2) are folded.

    `gaps` (n,) are those of the stations, n = S if closed, else S - 1. `base`: the
    lines that were displaced (V or 1, S, 2), and the lengths of their steps (V or 1, n); without it
    a step needs length but may go anywhere.
    """
    steps = _steps(points, closed)
    if base is None:
        advance = norm(steps)
    else:
        line, lengths = base
        advance = _dot(steps, _steps(line, closed)) / np.maximum(lengths, np.finfo(float).tiny)
    short = (advance <= LEAST_ADVANCE * gaps).any(axis=1)
    before, after = _neighbors(steps, closed, axis=1)
    return np.asarray(short | (_dot(before, after) <= 0.0).any(axis=1))


def turns_too_much(curvature: Floats, lengths: Floats, closed: bool) -> Booleans:
    """(V,) True where lines turn by a quarter turn over the mean of the two steps at a station.

    `curvature` (V, S) 1/m, `lengths` (V, n) meters of the steps.
    """
    if closed:
        mean = (lengths + np.roll(lengths, 1, axis=1)) / 2.0
    else:
        ends = np.concatenate([lengths[:, :1], lengths, lengths[:, -1:]], axis=1)
        mean = (ends[:, :-1] + ends[:, 1:]) / 2.0
    return np.asarray((np.abs(curvature) * mean >= QUARTER_TURN).any(axis=1))


@dataclass(frozen=True, eq=False)
class BaseSteps(SharedArrays):
    """The n steps of one line from station to station, and what displacements do to them.

    A displacement by e along the normals makes of a step, seen along itself and to its left,
    `length + e_before * forward[0] + e_after * forward[1]` and
    `e_before * sideways[0] + e_after * sideways[1]`.
    """

    curvature: Floats
    """(S,) 1/m of the line at its stations"""
    curvature_slope: Floats
    """(S,) 1/m^2"""
    gaps: Floats
    """(n,) meters from station to station"""
    length: Floats
    """(n,) meters of the steps"""
    forward: tuple[Floats, Floats]
    sideways: tuple[Floats, Floats]
    turn: tuple[Floats, Floats]
    """cosine and sine of the turn from each step to the next"""
    closed: bool

    @classmethod
    def of(
        cls,
        points: Floats,
        normal: Floats,
        bending: tuple[Floats, Floats],
        gaps: Floats,
        closed: bool,
    ) -> BaseSteps:
        """Of a line `points` (S, 2) with left normals (S, 2), curvature and its slope (S,) each,
        and `gaps` (n,) of its stations."""
        steps = _steps(points[None], closed)[0]
        length = norm(steps)
        along = steps / np.maximum(length, np.finfo(float).tiny)[:, None]
        left = left_of(along)
        before, after = _neighbors(normal, closed)
        earlier, following = _neighbors(along, closed)
        return cls(
            *bending,
            gaps,
            length,
            (-_dot(before, along), _dot(after, along)),
            (-_dot(before, left), _dot(after, left)),
            (_dot(earlier, following), cross(earlier, following)),
            closed,
        )

    def surely_smooth(self, displacement: Floats) -> Booleans:
        """(V,) A quick test that most rows pass: True where the line displaced by (V, S) meters is
        certain not to be folded, nor to turn too much."""
        if not are_even(self.gaps) or displacement.shape[1] <= 3:
            return np.zeros(len(displacement), dtype=bool)
        rows = Extremes.of(displacement, self.closed)
        return self._bounds.surely_smooth(rows, LEAST_ADVANCE)

    def folded(self, displacement: Floats) -> Booleans:
        """(V,) True where the line displaced by (V, S) meters is folded."""
        least = LEAST_ADVANCE * self.gaps
        backwards = (displacement * self.curvature >= 1.0 - LEAST_ADVANCE).any(axis=1)
        forward = self.length + self._part(displacement, self.forward)
        sideways = self._part(displacement, self.sideways)
        backwards |= (forward <= least).any(axis=1)
        ahead, next_ahead = _neighbors(forward, self.closed, axis=1)
        aside, next_aside = _neighbors(sideways, self.closed, axis=1)
        cosine, sine = self.turn
        onward = cosine * (ahead * next_ahead + aside * next_aside)
        onward += sine * (aside * next_ahead - ahead * next_aside)
        return np.asarray(backwards | (onward <= 0.0).any(axis=1))

    @cached_property
    def _bounds(self) -> FoldBounds:
        return FoldBounds.of(
            float(self.gaps.min()),
            self.length,
            self.forward,
            self.sideways,
            self.turn,
            (self.curvature, self.curvature_slope),
            _neighbors(self.curvature, self.closed),
            self.closed,
        )

    def _part(self, displacement: Floats, factors: tuple[Floats, Floats]) -> Floats:
        before, after = _neighbors(displacement, self.closed, axis=1)
        return before * factors[0] + after * factors[1]


def _steps(points: Floats, closed: bool) -> Floats:
    if closed:
        points = np.concatenate([points, points[:, :1]], axis=1)
    return np.diff(points, axis=1)


def _neighbors(values: Floats, closed: bool, axis: int = 0) -> tuple[Floats, Floats]:
    """Each value along `axis` but the last of an open line, and the value after it."""
    if closed:
        return values, np.roll(values, -1, axis=axis)
    count = values.shape[axis]
    return np.split(values, [count - 1], axis)[0], np.split(values, [1], axis)[1]


def _dot(a: Floats, b: Floats) -> Floats:
    """By component: a sum along an axis of two numbers takes ten times as long."""
    return np.asarray(a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1])
