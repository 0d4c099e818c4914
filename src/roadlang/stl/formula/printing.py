"""Canonical text of formulas: the words of the language, bare numbers."""

from __future__ import annotations

from ...syntax.operators import COMPARISON, PREFIXES
from . import formulas as f
from .interval import Interval
from .terms import number_text

_ATOM = 9


def interval_text(interval: Interval | None) -> str:
    """`[lo, hi]`, or nothing where the operator has no interval."""
    if interval is None:
        return ""
    return f"[{number_text(interval.lo)}, {number_text(interval.hi)}]"


def formula_text(formula: f.Formula) -> str:
    """What a temporal word governs stands in parentheses, as the language asks."""
    return _formula(formula, 0)


def _formula(formula: f.Formula, outer: int) -> str:
    text, level = _text_and_level(formula)
    return text if level >= outer else f"({text})"


def _text_and_level(formula: f.Formula) -> tuple[str, int]:
    match formula:
        case f.Truth(value):
            return ("true" if value else "false"), _ATOM
        case f.Comparison(op, left, right):
            return f"{left} {op} {right}", COMPARISON
        case f.LogicalJunction(()):
            return ("true" if formula.least else "false"), _ATOM
        case f.LogicalJunction((single,)):
            return _text_and_level(single)
        case f.LogicalJunction(operands):
            operator = formula.notation
            sides = [_side(operand, operator.operand_level) for operand in operands]
            return f" {operator.word} ".join(sides), operator.level
        case f.AtLeast():
            return _text_and_level(formula.measured)
        case f.Compound() if formula.notation.form in PREFIXES:
            word = f"{formula.word}{interval_text(formula.window)}"
            return f"{word} {_governed(formula.parts[0])}", formula.notation.level
        case f.BinaryTemporal(interval, left, right):
            operator = formula.notation
            word = f"{operator.word}{interval_text(interval)}"
            sides = [_side(side, operator.operand_level) for side in (left, right)]
            return f"{sides[0]} {word} {sides[1]}", operator.level
        case f.Measured(interval, operand, op, amount):
            subject = f"{formula.word}{interval_text(interval)} ({_formula(operand, 0)})"
            return f"{subject} {op} {number_text(amount)}", COMPARISON
        case f.Connective(left, right):
            operator = formula.notation
            before = _side(left, operator.operand_level)
            right_text = _formula(right, operator.operand_level)
            return f"{before} {operator.word} {right_text}", operator.level
    raise TypeError(f"not a formula: {formula!r}")


def _is_prefixed(formula: f.Formula) -> bool:
    if isinstance(formula, f.AtLeast) or not isinstance(formula, f.Compound):
        return False
    return formula.notation.form in PREFIXES


def _governed(operand: f.Formula) -> str:
    text = _formula(operand, 0)
    return text if _is_prefixed(operand) else f"({text})"


def _side(operand: f.Formula, level: int) -> str:
    """An operand with an operator to its right: there `always eventually (p)` is parenthesized."""
    if _is_prefixed(operand) and _is_prefixed(operand.parts[0]):
        return f"({_formula(operand, 0)})"
    return _formula(operand, level)
