"""How far a formula looks ahead and back along the axis."""

from __future__ import annotations

import math

from . import formulas as f


def horizon(formula: f.Formula) -> float:
    """The furthest that a sample ahead can matter: 0 for a state formula, inf without bounds."""
    return _reach(formula, f.FUTURE)


def memory(formula: f.Formula) -> float:
    """The furthest that a sample behind can matter."""
    return _reach(formula, f.PAST)


def _reach(formula: f.Formula, counted: tuple[type[f.Formula], ...]) -> float:
    below = max((_reach(part, counted) for part in formula.parts), default=0.0)
    if not isinstance(formula, counted):
        return below
    interval = getattr(formula, "interval", None)
    return below + (math.inf if interval is None else interval.hi)
