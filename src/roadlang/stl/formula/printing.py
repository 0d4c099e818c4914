"""Canonical text of terms and formulas: the words of the language, bare numbers."""

from __future__ import annotations

from . import formulas as f
from . import terms as t
from .interval import Interval

_TERM_LEVEL = {"^": 4, "*": 2, "/": 2, "+": 1, "-": 1}
_ATOM = 9
_PREFIXED = (f.Not, f.Always, f.Eventually, f.Once, f.Historically)
_COMPARISON, _PREFIX, _BINDING, _AND, _OR, _IMPLIES, _XOR, _IFF = 8, 7, 6, 5, 4, 3, 2, 1


def number_text(value: float) -> str:
    """The shortest text that reads back as `value`: `10`, `0.1`, `1e-07`, `inf`."""
    value = float(value)
    return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)


def term_text(term: t.Term) -> str:
    """Parentheses only where the precedence of the language needs them."""
    return _term(term, 0)


def _term(term: t.Term, outer: int) -> str:
    match term:
        case t.Constant(value):
            text, level = number_text(value), 3 if value < 0 else _ATOM
        case t.Variable(name):
            text, level = name, _ATOM
        case t.Negate(operand):
            text, level = f"-{_term(operand, 4)}", 3
        case t.Apply(function, arguments):
            text = f"{function}({', '.join(_term(argument, 0) for argument in arguments)})"
            level = _ATOM
        case t.Arithmetic(op, left, right):
            level = _TERM_LEVEL[op]
            near, far = (level + 1, level + 1) if op == "^" else (level, level + 1)
            text = f"{_term(left, near)} {op} {_term(right, far)}"
        case _:
            raise TypeError(f"not a term: {term!r}")
    return text if level >= outer else f"({text})"


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
            return f"{left} {op} {right}", _COMPARISON
        case f.Not(operand):
            return f"not {_governed(operand)}", _PREFIX
        case f.Always() | f.Eventually() | f.Once() | f.Historically():
            word = f"{type(formula).__name__.lower()}{interval_text(formula.interval)}"
            return f"{word} {_governed(formula.operand)}", _PREFIX
        case f.Until(interval, left, right) | f.Since(interval, left, right):
            word = f"{type(formula).__name__.lower()}{interval_text(interval)}"
            return f"{_side(left, _PREFIX)} {word} {_side(right, _PREFIX)}", _BINDING
        case f.And(operands):
            return _joined(operands, "and", "true", _AND)
        case f.Or(operands):
            return _joined(operands, "or", "false", _OR)
        case f.Implies(left, right):
            return f"{_side(left, _OR)} implies {_formula(right, _OR)}", _IMPLIES
        case f.Xor(left, right):
            return f"{_side(left, _PREFIX)} xor {_formula(right, _PREFIX)}", _XOR
        case f.Iff(left, right):
            return f"{_side(left, _OR)} iff {_formula(right, _OR)}", _IFF
    raise TypeError(f"not a formula: {formula!r}")


def _governed(operand: f.Formula) -> str:
    text = _formula(operand, 0)
    return text if isinstance(operand, _PREFIXED) else f"({text})"


def _side(operand: f.Formula, level: int) -> str:
    """An operand with an operator to its right: there `always eventually (p)` is parenthesized."""
    if isinstance(operand, _PREFIXED) and isinstance(operand.operand, _PREFIXED):
        return f"({_formula(operand, 0)})"
    return _formula(operand, level)


def _joined(operands: tuple[f.Formula, ...], word: str, empty: str, level: int) -> tuple[str, int]:
    if not operands:
        return empty, _ATOM
    if len(operands) == 1:
        return _text_and_level(operands[0])
    return f" {word} ".join(_side(operand, level + 1) for operand in operands), level
