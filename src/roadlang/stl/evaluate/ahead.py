"""Stand-ins, after the samples seen, for those that may still come."""

from __future__ import annotations

import math

import numpy as np

from ..formula import formulas as f
from .axis import TOLERANCE, SamplePositions
from .trace import FloatArray


def extended_axis(formula: f.Formula, positions: FloatArray) -> SamplePositions:
    """The samples seen and stand-ins for all later ones that `formula` can tell from each other.

    To a formula that looks back from seen samples only, every later sample is like the other:
    one stand-in, anywhere behind the trace, does.
    """
    last = float(positions[-1])
    slack = 8 * TOLERANCE * max(1.0, abs(last))
    marks = np.empty(0)
    if _looks_back_from_later(formula, False):
        marks = _marks(formula, positions, slack)
    borders = np.concatenate([[last], marks, [math.inf]])
    lows = np.insert(borders[:-1] + slack, np.arange(1, borders.size - 1), marks)
    highs = np.insert(borders[1:] - slack, np.arange(0, borders.size - 2) + 1, marks)
    return SamplePositions(
        np.concatenate([positions, lows]), None, np.concatenate([positions, highs])
    )


def _looks_back_from_later(formula: f.Formula, later: bool) -> bool:
    if isinstance(formula, f.TemporalOperator):
        if later and formula.past:
            return True
        later = later or not formula.past
    return any(_looks_back_from_later(part, later) for part in formula.parts)


def _marks(formula: f.Formula, positions: FloatArray, slack: float) -> FloatArray:
    """Places after the trace where a seen sample, moved by bounds of nested intervals, lies: there
    the samples in reach of some window change, and between them they do not.
    """
    last = float(positions[-1])
    shifts = np.array(sorted(_shifts(formula)))
    moved = np.unique((positions[:, None] + shifts).ravel())
    moved = moved[moved > last + 4 * slack]
    if not moved.size:
        return moved
    marks: FloatArray = moved[np.append(True, np.diff(moved) > 4 * slack)]
    return marks


def _shifts(formula: f.Formula) -> set[float]:
    """All sums of bounds, either way, of the intervals on a path from the root down."""
    below = {0.0}.union(*(_shifts(part) for part in formula.parts))
    interval = formula.window if isinstance(formula, f.Compound) else None
    if interval is None:
        return below
    bounds = [bound for bound in (interval.lo, interval.hi) if math.isfinite(bound)]
    shifts = [move for bound in bounds for move in (bound, -bound)]
    return {round(shift + move, 9) for shift in below for move in (0.0, *shifts)}
