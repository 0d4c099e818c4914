"""Formulas in the syntax of RTAMT, to cross-check with it; RTAMT itself is not needed."""

from __future__ import annotations

import math
import re

from ...diagnostics import Code
from ..errors import stl_error
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.interval import Interval
from ..formula.terms import number_text

_RESERVED = frozenset(
    {"G", "F", "U", "X", "H", "O", "S", "Y", "W", "s", "ms", "us", "ns", "ps", "abs", "sqrt"}
    | {"exp", "pow", "rise", "fall", "next", "prev", "s_next", "s_prev", "unless"}
)
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")


def to_rtamt(formula: f.Formula) -> str:
    """Text for `rtamt.StlDiscreteTimeSpecification`, every operator in parentheses.

    On evenly spaced samples its robustness is ours; set RTAMT's sampling period to the spacing.
    Raises DiagnosticError RL330 for what RTAMT cannot say.
    """
    match formula:
        case f.Comparison(op, left, right):
            sign = "!==" if op == "!=" else op
            return f"({_term(left)} {sign} {_term(right)})"
        case f.Derived() if not formula.notation.rtamt:
            return to_rtamt(formula.expanded())
        case f.Not(operand):
            return f"({formula.notation.rtamt} {to_rtamt(operand)})"
        case f.LogicalJunction() | f.Connective() if formula.parts:
            return _nested(formula.notation.rtamt, [to_rtamt(part) for part in formula.parts])
        case f.UnaryTemporal():
            return _unary(formula)
        case f.SampleStep(_, operand) | f.TruthChange(_, operand):
            return f"({formula.notation.rtamt} {to_rtamt(operand)})"
        case f.BinaryTemporal(interval, left, right):
            word = formula.notation.rtamt
            if interval is not None and interval.lo > 0 and math.isinf(interval.hi):
                raise _cannot(f"{word}[{number_text(interval.lo)}, inf]")
            return f"({to_rtamt(left)} {word}{_bounds(interval)} {to_rtamt(right)})"
    raise _cannot(str(formula))


def _unary(formula: f.UnaryTemporal) -> str:
    """[a, inf] is written in two steps: a ahead, and then without bounds."""
    word = formula.notation.rtamt
    interval = formula.interval
    text = to_rtamt(formula.operand)
    if interval is not None and interval.lo > 0 and math.isinf(interval.hi):
        text, interval = f"({word} {text})", Interval(interval.lo, interval.lo)
    return f"({word}{_bounds(interval)} {text})"


def _bounds(interval: Interval | None) -> str:
    if interval is None or math.isinf(interval.hi):
        return ""
    return f"[{number_text(interval.lo)},{number_text(interval.hi)}]"


def _nested(sign: str, parts: list[str]) -> str:
    text = parts[0]
    for part in parts[1:]:
        text = f"({text} {sign} {part})"
    return text


def _term(term: t.Term) -> str:
    match term:
        case t.Constant(value) if math.isfinite(value):
            return number_text(value) if value >= 0 else f"(0 - {number_text(-value)})"
        case t.Variable(name):
            if name in _RESERVED or not _NAME.match(name):
                raise _cannot(name)
            return name
        case t.Negate(operand):
            return f"(0 - {_term(operand)})"
        case t.Arithmetic("+" | "-" | "*" | "/" as op, left, right):
            return f"({_term(left)} {op} {_term(right)})"
        case t.Apply("abs", (argument,)):
            return f"abs({_term(argument)})"
    raise _cannot(str(term))


def _cannot(text: str) -> Exception:
    return stl_error(Code.NOT_EXPRESSIBLE_IN_RTAMT, text=text)
