"""Which displaced lines are certain not to be folded, from three numbers of each.

Bounds that hold for a whole row at once decide nearly all rows, and cost a fraction of the test of
every step in `roadlang.geometry.batches.folding`. For stations at even gaps.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Booleans, Floats
from ..numbers.row_blocks import blocks

_SURELY = 1.0 - 1e-9
"""Share of every limit: what rounding may decide is left to the exact test."""

_SMALL = 1e-100
_QUARTER = _SURELY * np.pi / 2.0


@dataclass(frozen=True)
class Extremes:
    """(V,) meters each: bounds on the size of displacements, on that of their change from one
    station to the next, and on that of the change of their change."""

    greatest: Floats
    change: Floats
    turn: Floats

    @classmethod
    def of(cls, displacement: Floats, closed: bool) -> Extremes:
        """Of displacements (V, S) at three stations or more."""
        greatest, turn = _greatest_and_turn(displacement)
        if closed:
            first, second = displacement[:, :2].T
            before, last = displacement[:, -2:].T
            for around in (second - 2.0 * first + last, first - 2.0 * last + before):
                turn = np.maximum(turn, np.abs(around))
        return cls(greatest, _change(greatest, turn, displacement.shape[1]), turn)


def _greatest_and_turn(displacement: Floats) -> tuple[Floats, Floats]:
    """(V,) each, of rows in blocks that fit the cache. A block is one row of numbers to the
    differences, and what goes across from the end of a row to the next is left out: that is four
    times as fast as many short rows."""
    count, stations = displacement.shape
    greatest, sharpest = np.empty((2, count))
    buffers = np.empty((2, 0))
    for rows in blocks(displacement, 1 << 14):
        moved = displacement[rows]
        flat = moved.reshape(-1)
        if flat.size > buffers.shape[1]:
            buffers = np.empty((2, flat.size))
        change, turn = buffers[:, : flat.size]
        np.subtract(flat[1:], flat[:-1], out=change[:-1])
        np.subtract(change[1:-1], change[:-2], out=turn[:-2])
        turns = turn.reshape(-1, stations)[:, :-2]
        np.maximum(moved.max(axis=1), -moved.min(axis=1), out=greatest[rows])
        np.maximum(turns.max(axis=1), -turns.min(axis=1), out=sharpest[rows])
    return greatest, sharpest


def _change(greatest: Floats, turn: Floats, stations: int) -> Floats:
    """(V,) no less than any change from one station to the next.

    The mean of m changes in a row is at most 2 greatest / m, and each of them is at most
    (m - 1) turn / 2 away from it; m = 2 sqrt(greatest / turn) makes the sum about least.
    """
    steps = np.rint(2.0 * np.sqrt(greatest / np.maximum(turn, _SMALL)))
    steps = np.clip(steps, 1.0, stations // 2)
    return np.asarray(2.0 * greatest / steps + turn * (steps - 1.0) / 2.0)


@dataclass(frozen=True)
class FoldBounds:
    """What bounds the steps of one line from station to station, whatever displaces it.

    Displaced by `mean - change / 2` and `mean + change / 2` at its ends, a step goes
    `length + mean * forward[0] + change * forward[1]` along itself and
    `mean * sideways[0] + change * sideways[1]` to its left. Kept are the greatest sizes of these
    factors, and of how they change from step to step (`forward_change`, `sideways_change`).
    """

    gap: float
    """meters from station to station"""
    shortest: float
    longest: float
    """meters of the steps"""
    length_change: float
    cosine: float
    sine: float
    """the least cosine and the greatest size of the sine of the turns from step to step"""
    curvature: float
    """1/m, the greatest size"""
    curvature_slope: float
    """1/m^2, the greatest size"""
    forward: tuple[float, float]
    forward_change: tuple[float, float]
    forward_excess: float
    """how far `forward[0]` is from what the tangents make of it, -gap * curvature"""
    sideways: tuple[float, float]
    sideways_change: tuple[float, float]
    sideways_excess: float
    """how far `sideways[1]` is from 1"""

    @classmethod
    def of(
        cls,
        gap: float,
        length: Floats,
        forward: tuple[Floats, Floats],
        sideways: tuple[Floats, Floats],
        turn: tuple[Floats, Floats],
        bending: tuple[Floats, Floats],
        around: tuple[Floats, Floats],
        closed: bool,
    ) -> FoldBounds:
        """Of the n steps of a line: see `BaseSteps`. `around`: (n,) curvatures at their ends."""
        ahead, aside = _of_mean_and_change(forward), _of_mean_and_change(sideways)

        def varied(values: Floats) -> float:
            return _greatest(np.diff(values, append=values[:1] if closed else values[-1:]))

        return cls(
            gap=gap,
            shortest=float(length.min()),
            longest=float(length.max()),
            length_change=varied(length),
            cosine=float(turn[0].min(initial=1.0)),
            sine=_greatest(turn[1]),
            curvature=_greatest(bending[0]),
            curvature_slope=_greatest(bending[1]),
            forward=(_greatest(ahead[0]), _greatest(ahead[1])),
            forward_change=(varied(ahead[0]), varied(ahead[1])),
            forward_excess=max(_greatest(ahead[0] + gap * end) for end in around),
            sideways=(_greatest(aside[0]), _greatest(aside[1])),
            sideways_change=(varied(aside[0]), varied(aside[1])),
            sideways_excess=_greatest(aside[1] - 1.0),
        )

    def surely_smooth(self, rows: Extremes, least_advance: float) -> Booleans:
        """(V,) True where every step keeps more than the share `least_advance` of the gap along the
        line, and none of the turns is a quarter turn: from step to step, and by the curvature over
        the mean of the two steps at a station."""
        lost = rows.greatest * self.forward[0] + rows.change * self.forward[1]
        aside = rows.greatest * self.sideways[0] + rows.change * self.sideways[1]
        advance = 1.0 - rows.greatest * self.curvature
        return np.asarray(
            (_SURELY * advance > least_advance)
            & (_SURELY * (self.shortest - lost) > least_advance * self.gap)
            & self._turn_little(rows, lost, aside)
            & (self._turned(rows, np.maximum(advance, least_advance), lost, aside) < _QUARTER)
        )

    def _turn_little(self, rows: Extremes, shortening: Floats, aside: Floats) -> Booleans:
        """Two steps (f, s) and (f', s'), f along the line and s to its left, turn by less than a
        quarter while `cosine * (f f' + s s') + sine * (s f' - f s')` is positive. Of opposite sign,
        s and s' multiply to no less than -((s' - s) / 2)^2."""
        greatest, change = rows.greatest, rows.change
        smallest = self.shortest - shortening
        change_forward = (
            self.length_change
            + greatest * self.forward_change[0]
            + change * (self.forward_change[1] + self.forward[0])
            + rows.turn * self.forward[1]
        )
        change_aside = np.minimum(
            greatest * self.sideways_change[0]
            + change * (self.sideways_change[1] + self.sideways[0])
            + rows.turn * self.sideways[1],
            2.0 * aside,
        )
        along = smallest**2 - change_aside**2 / 4.0
        across = aside * change_forward + (self.longest + shortening) * change_aside
        return np.asarray(_SURELY * self.cosine * along > self.sine * across)

    def _turned(self, rows: Extremes, advance: Floats, shortening: Floats, aside: Floats) -> Floats:
        """(V,) radians that the turns by the curvature do not exceed.

        With f = 1 - k e and w^2 = f^2 + e'^2 the curvature K is
        (f (f k + e'') + e' (k' e + 2 k e')) / w^3, so that
        K w <= k (1 + e'^2 / w^2) + (e'' + k' e / 2) / f. The derivatives are differences, at the
        ends one-sided ones. The mean of two steps is no longer than the longest, and than w times
        the gap and what the steps may differ from that.
        """
        greatest, change, turn = rows.greatest, rows.change, rows.turn
        slope, bend = (change + turn / 2.0) / self.gap, 3.0 * turn / self.gap**2
        straight = slope**2 / (advance**2 + slope**2)
        turned = self.curvature * (1.0 + straight)
        turned += (bend + self.curvature_slope * greatest / 2.0) / advance
        longer = (
            max(self.longest - self.gap, 0.0)
            + greatest * (self.forward_excess + self.sideways[0])
            + change * (self.forward[1] + self.gap * self.curvature / 2.0 + self.sideways_excess)
            + turn / 2.0
        )
        longest = np.hypot(self.longest + shortening, aside)
        return np.asarray(turned * np.minimum(self.gap + longer / advance, longest / advance))


def _of_mean_and_change(factors: tuple[Floats, Floats]) -> tuple[Floats, Floats]:
    """Of factors of the displacements before and after: those of their mean and their change."""
    return factors[0] + factors[1], (factors[1] - factors[0]) / 2.0


def _greatest(values: Floats) -> float:
    return float(np.abs(values).max(initial=0.0))
