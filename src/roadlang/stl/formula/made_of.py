"""What formulas that a program builds are made of. All raise `TypeError` for anything else, and
`ValueError` for a word that is no operator."""

from __future__ import annotations

from typing import Any, Literal, TypeAlias, TypeVar, get_args

from ...diagnostics import did_you_mean
from ...diagnostics.arguments import number, text, wrong_type
from .interval import Interval
from .terms import Apply, Arithmetic, ArithmeticOperator, Constant, FunctionName, Term, Variable

ComparisonOperator: TypeAlias = Literal["<", "<=", ">", ">=", "==", "!="]

T = TypeVar("T")


def checked_part(whole: object, part: Any, formulas: type[T]) -> T:
    """A formula that another one is made of."""
    if not isinstance(part, formulas):
        expected = "a formula, which `roadlang.stl.parse` makes of text"
        raise wrong_type(f"part of {type(whole).__name__}", expected, part)
    return part


def checked_sides(comparison: Any) -> tuple[Term, Term]:
    """The sides of a comparison, whose operator there is."""
    _check_word(comparison, "op", comparison.op, get_args(ComparisonOperator))
    return _checked_side(comparison.left), _checked_side(comparison.right)


def _checked_side(side: Any) -> Term:
    """A side of a comparison, with all that it is made of."""
    if not isinstance(side, Term):
        expected = "a term, such as `Variable('x')` or `Constant(5.0)`"
        raise wrong_type("side of Comparison", expected, side)
    if isinstance(side, Constant):
        number("value of Constant", side.value)
    elif isinstance(side, Variable):
        text("name of Variable", side.name)
    elif isinstance(side, Arithmetic):
        _check_word(side, "op", side.op, get_args(ArithmeticOperator))
    elif isinstance(side, Apply):
        _check_word(side, "function", side.function, get_args(FunctionName))
    for part in side.parts:
        if not isinstance(part, Term):
            expected = "a term, such as `Variable('x')` or `Constant(5.0)`"
            raise wrong_type(f"part of {type(side).__name__}", expected, part)
        _checked_side(part)
    return side


def _check_word(whole: object, name: str, word: Any, known: tuple[str, ...]) -> None:
    """Raises `ValueError` for an operator or function that there is none of."""
    if word not in known:
        owner = type(whole).__name__
        help_ = did_you_mean(str(word), known)
        listed = ", ".join(f"`{each}`" for each in known)
        hint = f": {help_[0]}" if help_ else ""
        raise ValueError(f"`{name}` of {owner} must be one of {listed}, not {word!r}{hint}")


def checked_interval(interval: Any) -> Interval | None:
    """The interval of a temporal operator."""
    if not isinstance(interval, Interval | None):
        raise wrong_type("interval", "an `Interval` or None", interval)
    return interval
