"""Stand-ins, after the samples seen, for those that may still come."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np

from ..formula import formulas as f
from .axis import SamplePositions, slack
from .trace import FloatArray


def extended_axis(formula: f.Formula, positions: FloatArray) -> SamplePositions:
    """The samples seen and stand-ins for all later ones that `formula` can tell from each other.

    To a formula that looks back from seen samples only, every later sample is like the other:
    one stand-in, anywhere behind the trace, does.
    """
    axis = SamplePositions.of(positions)
    last = float(axis.positions[-1])
    shifts = _shifts(formula) if _looks_back_from_later(formula, False) else ()
    furthest = np.array(last + max(shifts, default=0.0))
    apart = 8 * float(slack(furthest, axis.tolerance))
    marks = _marks(axis.positions, np.array(sorted(shifts)), apart)
    borders = np.concatenate([[last], marks, [math.inf]])
    lows = np.insert(borders[:-1] + apart, np.arange(1, borders.size - 1), marks)
    highs = np.insert(borders[1:] - apart, np.arange(0, borders.size - 2) + 1, marks)
    return replace(
        axis,
        positions=np.concatenate([axis.positions, lows]),
        ends=np.concatenate([axis.positions, highs]),
        seen=axis.size,
    )


def _looks_back_from_later(formula: f.Formula, later: bool) -> bool:
    if isinstance(formula, f.TemporalOperator):
        if later and formula.past:
            return True
        later = later or not formula.past
    return any(_looks_back_from_later(part, later) for part in formula.parts)


def _marks(positions: FloatArray, shifts: FloatArray, apart: float) -> FloatArray:
    """Places after the trace where a seen sample, moved by bounds of nested intervals, lies: there
    the samples in reach of some window change, and between them they do not.
    """
    last = float(positions[-1])
    moved = np.unique((positions[:, None] + shifts).ravel())
    moved = moved[moved > last + 4 * apart]
    if not moved.size:
        return moved
    marks: FloatArray = moved[np.append(True, np.diff(moved) > 4 * apart)]
    return marks


def _shifts(formula: f.Formula) -> tuple[float, ...]:
    """All sums of bounds, either way, of the intervals on a path from the root down.

    Sums that differ by rounding only are one.
    """
    below = (0.0, *(shift for part in formula.parts for shift in _shifts(part)))
    interval = formula.window if isinstance(formula, f.Compound) else None
    bounds = [] if interval is None else [interval.lo, interval.hi]
    offsets = [0.0, *(sign * bound for bound in bounds if math.isfinite(bound) for sign in (1, -1))]
    sums = sorted(shift + move for shift in below for move in offsets)
    rounding = 16 * math.ulp(max(abs(sums[0]), abs(sums[-1])))
    distinct = [sums[0]]
    distinct += [b for a, b in itertools.pairwise(sums) if b - a > rounding]
    return tuple(distinct)
