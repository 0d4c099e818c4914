"""How far a formula looks ahead and back along the axis."""

from __future__ import annotations

import math

from . import formulas as f


def horizon(formula: f.Formula) -> float:
    """The furthest that a sample ahead can matter: 0 for a state formula, inf without bounds."""
    return _furthest(formula, past=False)


def memory(formula: f.Formula) -> float:
    """The farthest that an earlier sample can matter."""
    return _furthest(formula, past=True)


def _furthest(formula: f.Formula, *, past: bool) -> float:
    below = max((_furthest(part, past=past) for part in formula.parts), default=0.0)
    if not isinstance(formula, f.TemporalOperator) or formula.past != past:
        return below
    return below + (math.inf if formula.window is None else formula.window.hi)
