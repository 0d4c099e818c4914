"""Formulas as JSON values and back: {"always": {...}, "interval": [0, 50]}.

A term is a number, a name, `{"-": [x]}` or `{op or function: [x, y]}`; a comparison is
`{"<": [x, y]}`; `{"and": [p, q]}`; `{"until": [p, q], "interval": [2, null]}`, where null is
infinity; `{"count": [p, "<=", 3], "interval": [0, 10]}`. Truth values are JSON's own.
"""

from __future__ import annotations

import json
import math
from typing import Any, cast, get_args

from ...diagnostics import Code
from ...syntax.operators import OPERATORS, PREFIXES
from ..errors import stl_error
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.interval import Interval
from ..formula.measures import MeasureComparison

Json = Any

_WORDS = {operator.json: operator.word for operator in OPERATORS}
_UNARY = {operator.json for operator in OPERATORS if operator.form in PREFIXES}
"""Their operand stands by itself, not in a list."""
_LONGEST = 60
_OPERATORS = {*_WORDS, *get_args(f.ComparisonOperator)}


def to_json(formula: f.Formula) -> Json:
    """The JSON value of a formula."""
    match formula:
        case f.Truth(value):
            return value
        case f.Comparison(op, left, right):
            return {op: [_term_to_json(left), _term_to_json(right)]}
        case f.Compound():
            formula = formula.measured if isinstance(formula, f.AtLeast) else formula
            tag, window = formula.notation.json, formula.window
            parts = [to_json(part) for part in formula.parts]
            if isinstance(formula, f.Measured):
                parts += [formula.op, formula.amount]
            result: dict[str, Json] = {tag: parts[0] if tag in _UNARY else parts}
            if window is not None:
                result["interval"] = [window.lo, None if math.isinf(window.hi) else window.hi]
            return result
    raise TypeError(f"not a formula: {formula!r}")


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
    if word not in _OPERATORS:
        raise _refusal(value)
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


def _formula(tag: str, operands: Json, interval: Interval | None) -> f.Formula:
    kind = f.COMPOUNDS[_WORDS[tag]]
    if issubclass(kind, f.Measured):
        operand, op, amount = operands
        if op not in get_args(MeasureComparison):
            raise ValueError(op)
        return kind(interval, from_json(operand), op, _amount(amount))
    parts = [from_json(operand) for operand in ([operands] if tag in _UNARY else operands)]
    return f.compound(_WORDS[tag], parts, interval)


def _amount(value: Json) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise TypeError(value)
    return float(value)


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
    if not isinstance(value, dict):
        raise _refusal(value)
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
    return stl_error(Code.INVALID_JSON_FORMULA, found=shown(value))


def shown(value: Any) -> str:
    """A value as JSON has it, at most sixty characters of it, for a message."""
    text = json.dumps(value, default=repr)
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."
