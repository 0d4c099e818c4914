"""Formulas as JSON values and back: {"always": {...}, "interval": [0, 50]}.

A term is a number, a name, `{"-": [x]}` or `{op or function: [x, y]}`; a comparison is
`{"<": [x, y]}`; `{"and": [p, q]}`; `{"until": [p, q], "interval": [2, null]}`, where null is
infinity. Truth values are JSON's own.
"""

from __future__ import annotations

import math
from typing import Any, cast, get_args

from ...diagnostics import Code
from ..errors import stl_error
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.interval import Interval

Json = Any

_UNARY = {"always": f.Always, "eventually": f.Eventually, "once": f.Once,
          "historically": f.Historically}  # fmt: skip
_BINARY = {"until": f.Until, "since": f.Since}
_LOGIC = {"implies": f.Implies, "iff": f.Iff, "xor": f.Xor}


def to_json(formula: f.Formula) -> Json:
    """The JSON value of a formula."""
    match formula:
        case f.Truth(value):
            return value
        case f.Comparison(op, left, right):
            return {op: [_term_to_json(left), _term_to_json(right)]}
    word = type(formula).__name__.lower()
    parts = [to_json(part) for part in formula.parts]
    single = isinstance(formula, (f.Not, *_UNARY.values()))
    result: dict[str, Json] = {word: parts[0] if single else parts}
    interval = getattr(formula, "interval", None)
    if interval is not None:
        result["interval"] = [interval.lo, None if math.isinf(interval.hi) else interval.hi]
    return result


def _term_to_json(term: t.Term) -> Json:
    match term:
        case t.Constant(value):
            return value
        case t.Variable(name):
            return name
        case t.Negate(operand):
            return {"-": [_term_to_json(operand)]}
        case t.Arithmetic(op, left, right):
            return {op: [_term_to_json(left), _term_to_json(right)]}
        case t.Apply(function, arguments):
            return {function: [_term_to_json(argument) for argument in arguments]}
    raise TypeError(f"not a term: {term!r}")


def from_json(value: Json) -> f.Formula:
    """The formula of a JSON value. Raises DiagnosticError RL310 where it is none."""
    if isinstance(value, bool):
        return f.Truth(value)
    if not isinstance(value, dict):
        raise _refusal(value)
    word, operands = _head(value)
    try:
        if word in get_args(f.ComparisonOperator):
            left, right = (_term_from_json(operand) for operand in operands)
            return f.Comparison(cast(f.ComparisonOperator, word), left, right)
        return _formula(word, operands, _interval(value.get("interval")))
    except (TypeError, ValueError) as problem:
        raise _refusal(value) from problem


def _head(value: dict[str, Json]) -> tuple[str, Json]:
    heads = [(word, operands) for word, operands in value.items() if word != "interval"]
    if len(heads) != 1:
        raise _refusal(value)
    return heads[0]


def _formula(word: str, operands: Json, interval: Interval | None) -> f.Formula:
    if word == "not":
        return f.Not(from_json(operands))
    if word in _UNARY:
        return _UNARY[word](interval, from_json(operands))
    parts = tuple(from_json(operand) for operand in operands)
    if word in ("and", "or"):
        return f.And(parts) if word == "and" else f.Or(parts)
    left, right = parts
    if word in _BINARY:
        return _BINARY[word](interval, left, right)
    if word in _LOGIC:
        return _LOGIC[word](left, right)
    raise ValueError(word)


def _interval(bounds: Json) -> Interval | None:
    if bounds is None:
        return None
    lo, hi = bounds
    return Interval(float(lo), math.inf if hi is None else float(hi))


def _term_from_json(value: Json) -> t.Term:
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return t.Constant(float(value))
    if isinstance(value, str):
        return t.Variable(value)
    word, operands = _head(value)
    parts = tuple(_term_from_json(operand) for operand in operands)
    if word in get_args(t.FunctionName):
        return t.Apply(cast(t.FunctionName, word), parts)
    if word == "-" and len(parts) == 1:
        return t.Negate(parts[0])
    if word not in get_args(t.ArithmeticOperator):
        raise ValueError(word)
    left, right = parts
    return t.Arithmetic(cast(t.ArithmeticOperator, word), left, right)


def _refusal(value: Json) -> Exception:
    shown = repr(value)
    return stl_error(
        Code.INVALID_JSON_FORMULA, found=shown if len(shown) <= 60 else f"{shown[:57]}..."
    )
