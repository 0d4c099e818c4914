"""What formulas that a program builds are made of. All raise `TypeError` for anything else."""

from __future__ import annotations

from typing import Any, TypeVar

from ...diagnostics.arguments import wrong_type
from .interval import Interval
from .terms import Term

T = TypeVar("T")


def checked_part(whole: object, part: Any, formulas: type[T]) -> T:
    """A formula that another one is made of."""
    if not isinstance(part, formulas):
        expected = "a formula, which `roadlang.stl.parse` makes of text"
        raise wrong_type(f"part of {type(whole).__name__}", expected, part)
    return part


def checked_side(side: Any) -> Term:
    """A side of a comparison."""
    if not isinstance(side, Term):
        expected = "a term, such as `Variable('x')` or `Constant(5.0)`"
        raise wrong_type("side of Comparison", expected, side)
    return side


def checked_interval(interval: Any) -> Interval | None:
    """The interval of a temporal operator."""
    if not isinstance(interval, Interval | None):
        raise wrong_type("interval", "an `Interval` or None", interval)
    return interval
