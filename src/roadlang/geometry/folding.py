"""Whether a displaced road runs backwards, or its stations stand too close, for many rows at once.

A displacement of a bend towards its inside shortens it; at the center of the bend it has no length,
and beyond it runs backwards. A road is *folded* where, between two neighboring stations,

- it advances along the road that it was made from by less than `LEAST_ADVANCE` of their gap, or
- it turns by a quarter turn or more from one step to the next.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .arrays import Booleans, Floats, SharedArrays, cross, left_of, norm
from .displacement import blocks

LEAST_ADVANCE = 0.05
"""Share of the gap between stations that is left of every step of a road that is not folded."""


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


@dataclass(frozen=True, eq=False)
class BaseSteps(SharedArrays):
    """The n steps of one line from station to station, and what displacements do to them.

    A displacement by e along the normals makes of a step, seen along itself and to its left,
    `length + e_before * forward[0] + e_after * forward[1]` and
    `e_before * sideways[0] + e_after * sideways[1]`.
    """

    curvature: Floats
    """(S,) 1/m of the line at its stations"""
    length: Floats
    """(n,) meters"""
    least: Floats
    """(n,) meters that a step must advance"""
    forward: tuple[Floats, Floats]
    sideways: tuple[Floats, Floats]
    turn: tuple[Floats, Floats]
    """cosine and sine of the turn from each step to the next"""
    closed: bool

    @classmethod
    def of(
        cls, points: Floats, normal: Floats, curvature: Floats, gaps: Floats, closed: bool
    ) -> BaseSteps:
        """Of a line `points` (S, 2) with left normals (S, 2) and `gaps` (n,) of its stations."""
        steps = _steps(points[None], closed)[0]
        length = norm(steps)
        along = steps / np.maximum(length, np.finfo(float).tiny)[:, None]
        left = left_of(along)
        before, after = _neighbors(normal, closed)
        earlier, following = _neighbors(along, closed)
        return cls(
            curvature,
            length,
            LEAST_ADVANCE * gaps,
            (-_dot(before, along), _dot(after, along)),
            (-_dot(before, left), _dot(after, left)),
            (_dot(earlier, following), cross(earlier, following)),
            closed,
        )

    def folded(self, displacement: Floats) -> Booleans:
        """(V,) True where the line displaced by (V, S) meters is folded."""
        result = np.empty(len(displacement), dtype=bool)
        for rows in blocks(displacement):
            doubtful = ~self._surely_smooth(displacement[rows])
            found = np.zeros(len(doubtful), dtype=bool)
            if doubtful.any():
                found[doubtful] = self._folded(displacement[rows][doubtful])
            result[rows] = found
        return result

    def _surely_smooth(self, displacement: Floats) -> Booleans:
        """A quick test that most rows pass, by the greatest displacement and its greatest change.

        With the middle and the difference of the displacements at the ends of a step, both parts
        of the step are bounded by numbers that are the same for all rows.
        """
        greatest = np.maximum(displacement.max(axis=1), -displacement.min(axis=1))
        change = displacement[:, 1:] - displacement[:, :-1]
        slope = np.maximum(change.max(axis=1), -change.min(axis=1))
        if self.closed:
            slope = np.maximum(slope, np.abs(displacement[:, 0] - displacement[:, -1]))
        forward, sideways = self._bounds
        lost = greatest * forward[0] + slope * forward[1]
        aside = greatest * sideways[0] + slope * sideways[1]
        cosine = float(self.turn[0].min(initial=1.0))
        # Two steps that each leave their base by less than the half of what the base's own
        # turn leaves of a quarter turn do not turn by a quarter turn.
        steepest = np.tan(max(0.0, np.pi / 2.0 - np.arccos(np.clip(cosine, -1.0, 1.0))) / 2.0)
        return np.asarray(
            (greatest * np.abs(self.curvature).max() < 1.0 - LEAST_ADVANCE)
            & (lost < (self.length - self.least).min())
            & (aside < steepest * (self.length.min() - lost))
        )

    @cached_property
    def _bounds(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Of both parts of a step: per meter of displacement, and per meter of its change."""
        return tuple(  # type: ignore[return-value]
            (float(np.abs(b + a).max()), float(np.abs(a - b).max()) / 2.0)
            for b, a in (self.forward, self.sideways)
        )

    def _folded(self, displacement: Floats) -> Booleans:
        backwards = (displacement * self.curvature >= 1.0 - LEAST_ADVANCE).any(axis=1)
        forward = self.length + self._part(displacement, self.forward)
        sideways = self._part(displacement, self.sideways)
        backwards |= (forward <= self.least).any(axis=1)
        ahead, next_ahead = _neighbors(forward, self.closed, axis=1)
        aside, next_aside = _neighbors(sideways, self.closed, axis=1)
        cosine, sine = self.turn
        onward = cosine * (ahead * next_ahead + aside * next_aside)
        onward += sine * (aside * next_ahead - ahead * next_aside)
        return np.asarray(backwards | (onward <= 0.0).any(axis=1))

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
    return np.asarray((a * b).sum(axis=-1))
