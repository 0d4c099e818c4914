"""The JSON Schema of formulas and terms, from the table of operators."""

from __future__ import annotations

from typing import Any, get_args

from ...syntax.operators import OPERATORS, PREFIXES, Operator
from ..formula import formulas as f
from ..formula import terms as t
from ..formula.measures import MeasureComparison

FORMULA, TERM = {"$ref": "#/$defs/Formula"}, {"$ref": "#/$defs/Term"}
_INTERVAL = {
    "description": "[from, to] in meters along the road or seconds; null: without end",
    "type": "array",
    "prefixItems": [{"type": "number"}, {"type": ["number", "null"]}],
    "minItems": 2,
    "items": False,
}


def formula_definitions() -> dict[str, Any]:
    """The definitions `Formula` and `Term`, which name each other."""
    comparisons = [_single({op: _list(TERM, 2, 2)}) for op in get_args(f.ComparisonOperator)]
    return {
        "Formula": {
            "description": 'a formula of STL: {"always": {"<": ["x", 3.0]}, "interval": [0, 50]}',
            "anyOf": [{"type": "boolean"}, *comparisons, *map(_operator, OPERATORS)],
        },
        "Term": {
            "description": 'a number, the name of a signal or number, or {"+": [term, term]}',
            "anyOf": [{"type": "number"}, {"type": "string"}, *_computed()],
        },
    }


def _operator(operator: Operator) -> dict[str, Any]:
    if operator.form in PREFIXES:
        operands: dict[str, Any] = FORMULA
    elif operator.form == "measure":
        sign = {"enum": list(get_args(MeasureComparison))}
        prefix = [FORMULA, sign, {"type": "number"}]
        operands = {"type": "array", "prefixItems": prefix, "minItems": 3, "items": False}
    elif operator.form == "binding" or issubclass(f.COMPOUNDS[operator.word], f.Connective):
        operands = _list(FORMULA, 2, 2)
    else:
        operands = _list(FORMULA)
    has_interval = operator.form in ("temporal", "binding", "measure")
    return _single({operator.json: operands}, {"interval": _INTERVAL} if has_interval else {})


def _computed() -> list[dict[str, Any]]:
    least = dict.fromkeys(get_args(t.ArithmeticOperator), 2) | {"-": 1}
    arithmetic = [_single({op: _list(TERM, count, 2)}) for op, count in least.items()]
    return arithmetic + [_single({name: _list(TERM, 1)}) for name in get_args(t.FunctionName)]


def _list(item: dict[str, Any], least: int = 0, most: int | None = None) -> dict[str, Any]:
    bounds = {"minItems": least, **({} if most is None else {"maxItems": most})}
    return {"type": "array", "items": item, **bounds}


def _single(required: dict[str, Any], optional: dict[str, Any] | None = None) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": {**required, **(optional or {})},
        "required": list(required),
        "additionalProperties": False,
    }
