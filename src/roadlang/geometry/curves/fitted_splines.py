"""Splines through points whose knots are, as nearly as the points allow, their own arc lengths."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..arrays import Floats, norm
from .spline import PiecewiseCubic
from .spline_rows import interpolate_each, lengths_of_pieces

_REFITS = 12
_LONGEST_STEP = 1.2
_CUTS = 4


class _Knots(NamedTuple):
    """Steps (m,) between knots, chords (m,) of the points there, and how far the steps are from
    those before, as a share of all chords."""

    chords: Floats
    steps: Floats
    error: float = np.inf

    @staticmethod
    def of(points: Floats, closed: bool) -> _Knots:
        ring = np.concatenate([points, points[:1]]) if closed else points
        chords = norm(ring[1:] - ring[:-1])
        return _Knots(chords, chords)

    @property
    def places(self) -> Floats:
        return np.concatenate([[0.0], np.cumsum(self.steps)])

    def after(self, lengths: Floats) -> _Knots | None:
        """Those of the spline whose pieces have these lengths (m,); None if no closer."""
        steps = np.minimum(lengths, _LONGEST_STEP * self.chords)
        change = np.abs(steps - self.steps).max() / self.chords.sum()
        if change >= self.error or change <= 1e-13:
            return None
        return _Knots(self.chords, steps, change)


def fitted(rows: Sequence[Floats], closed: bool) -> list[PiecewiseCubic]:
    """The spline through each row of points (n, 2), in order.

    From rough points the fixed point may repel: a long step makes a loose piece, which makes a
    longer step. So steps are capped at the arc of 120 degrees over the chord, and the refits stop
    when they no longer come closer.
    """
    knots = [_Knots.of(points, closed) for points in rows]
    splines = interpolate_each([row.places for row in knots], rows, closed)
    going = list(range(len(rows)))
    for _ in range(_REFITS):
        lengths = lengths_of_pieces([splines[index] for index in going], _CUTS)
        closer = {
            index: after
            for index, pieces in zip(going, lengths, strict=True)
            if (after := knots[index].after(pieces.sum(axis=1))) is not None
        }
        going = list(closer)
        if not going:
            break
        places, points = [closer[index].places for index in going], [rows[i] for i in going]
        for index, spline in zip(going, interpolate_each(places, points, closed), strict=True):
            knots[index], splines[index] = closer[index], spline
    return splines
