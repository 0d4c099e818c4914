"""Whether a displaced road runs backwards, or bends more sharply than its stations can show.

A displacement of a bend towards its inside shortens it; at the center of the bend it has no length,
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

from .arrays import Booleans, Floats, SharedArrays, cross, left_of, norm
from .differences import are_even
from .row_blocks import blocks

LEAST_ADVANCE = 0.05
"""Share of the gap between stations that is left of every step of a road that is not folded."""

QUARTER_TURN = np.pi / 2.0


def fold_of_points(
    points: Floats, gaps: Floats, closed: bool, base: Floats | None = None
) -> Booleans:
    """(V,) True where the lines `points` (V, S, 2) are folded.

    `gaps` (n,) are those of the stations, n = S if closed, else S - 1. `base` (V or 1, S, 2): the
    lines that were displaced; without it a step needs length but may go anywhere.
    """
    steps = _steps(points, closed)
    if base is None:
        advance = norm(steps)
    else:
        along = _steps(base, closed)
        advance = (steps * along).sum(axis=-1) / np.maximum(norm(along), np.finfo(float).tiny)
    short = (advance <= LEAST_ADVANCE * gaps).any(axis=1)
    before, after = _neighbors(steps, closed, axis=1)
    return np.asarray(short | ((before * after).sum(axis=-1) <= 0.0).any(axis=1))


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
        result = np.zeros(len(displacement), dtype=bool)
        if are_even(self.gaps) and displacement.shape[1] > 3:
            for rows in blocks(displacement):
                result[rows] = self._surely_smooth(*self._extremes(displacement[rows]))
        return result

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

    def _extremes(self, displacement: Floats) -> tuple[Floats, Floats, Floats]:
        """(V,) each: the greatest displacement, its greatest change from one station to the next,
        and the greatest change of that."""
        change = displacement[:, 1:] - displacement[:, :-1]
        bend = change[:, 1:] - change[:, :-1]
        greatest, slope, turn = (
            np.maximum(part.max(axis=1), -part.min(axis=1)) for part in (displacement, change, bend)
        )
        if self.closed:
            first, second = displacement[:, :2].T
            before, last = displacement[:, -2:].T
            slope = np.maximum(slope, np.abs(first - last))
            for around in (second - 2.0 * first + last, first - 2.0 * last + before):
                turn = np.maximum(turn, np.abs(around))
        return greatest, slope, turn

    def _surely_smooth(self, greatest: Floats, slope: Floats, turn: Floats) -> Booleans:
        """With the middle and the difference of the displacements at the ends of a step, both parts
        of the step are bounded by numbers that are the same for all rows; so is the curvature, with
        what one-sided differences at the ends may make of the derivatives."""
        limits = self._limits
        lost = greatest * limits.forward[0] + slope * limits.forward[1]
        aside = greatest * limits.sideways[0] + slope * limits.sideways[1]
        smallest = limits.shortest - lost
        advance = 1.0 - greatest * limits.curvature
        rate, bend = (slope + turn / 2.0) / limits.gap, 3.0 * turn / limits.gap**2
        speed = np.maximum(advance, LEAST_ADVANCE)
        around = (2.0 - advance) * limits.curvature + bend
        twist = rate * (limits.curvature_slope * greatest + 2.0 * limits.curvature * rate)
        curvature = around / speed**2 + twist / speed**3
        return np.asarray(
            (advance > LEAST_ADVANCE)
            & (smallest > LEAST_ADVANCE * limits.gap)
            & (aside < limits.steepest * smallest)
            & (curvature * np.hypot(limits.longest + lost, aside) < QUARTER_TURN)
        )

    @cached_property
    def _limits(self) -> _Limits:
        cosine = float(self.turn[0].min(initial=1.0))
        (before, after), (left_before, left_after) = self.forward, self.sideways
        return _Limits(
            forward=(_greatest(before + after), _greatest(after - before) / 2.0),
            sideways=(_greatest(left_before + left_after), _greatest(left_after - left_before) / 2),
            curvature=_greatest(self.curvature),
            curvature_slope=_greatest(self.curvature_slope),
            gap=float(self.gaps.min()),
            shortest=float(self.length.min()),
            longest=float(self.length.max()),
            steepest=float(np.tan(max(0.0, QUARTER_TURN - np.arccos(np.clip(cosine, -1, 1))) / 2)),
        )

    def _part(self, displacement: Floats, factors: tuple[Floats, Floats]) -> Floats:
        before, after = _neighbors(displacement, self.closed, axis=1)
        return before * factors[0] + after * factors[1]


@dataclass(frozen=True)
class _Limits:
    """What bounds the steps of a line, whatever displaces it.

    `forward` and `sideways`: how much of a step a displacement takes, and its change from one
    station to the next. `steepest`: two steps that leave their base by less than this tangent, half
    of what the base's own turn leaves of a quarter turn, do not turn by a quarter turn.
    """

    forward: tuple[float, float]
    sideways: tuple[float, float]
    curvature: float
    curvature_slope: float
    gap: float
    shortest: float
    longest: float
    steepest: float


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
    return np.asarray((a * b).sum(axis=-1))


def _greatest(values: Floats) -> float:
    return float(np.abs(values).max(initial=0.0))
