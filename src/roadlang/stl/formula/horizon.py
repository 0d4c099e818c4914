"""How far a formula looks ahead and back along the axis."""

from __future__ import annotations

import math

from . import formulas as f


def horizon(formula: f.Formula) -> float:
    """The furthest that a sample ahead can matter: 0 for a state formula, inf without bounds.

    The neighboring sample, wherever it is, counts as 0 away (see `looks_at_neighbors`).
    """
    return _furthest(formula, past=False)


def memory(formula: f.Formula) -> float:
    """The farthest that an earlier sample can matter."""
    return _furthest(formula, past=True)


def _furthest(formula: f.Formula, *, past: bool) -> float:
    below = max((_furthest(part, past=past) for part in formula.parts), default=0.0)
    if not isinstance(formula, f.TemporalOperator) or formula.past != past:
        return below
    if isinstance(formula, f.SampleStep | f.TruthChange):
        return below
    return below + (math.inf if formula.window is None else formula.window.hi)


def looks_at_neighbors(formula: f.Formula) -> bool:
    """Whether an operator counts samples instead of distance, as `next` does."""
    return any(isinstance(part, f.SampleStep | f.TruthChange) for part in formula.walk())
