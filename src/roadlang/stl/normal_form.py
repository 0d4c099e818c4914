"""Formulas in the few operators that the kernels know, negations pushed to the comparisons.

The rewriting changes neither robustness (to the last bit: x - y and -(y - x) round alike), nor
Boolean satisfaction. What remains: Truth, Comparison, And, Or, the temporal operators, and Not
in front of until and since, which have no dual here.
"""

from __future__ import annotations

from collections.abc import Iterable

from . import formulas as f

_OPPOSITE: dict[f.ComparisonOperator, f.ComparisonOperator] = {
    "<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "==",
}  # fmt: skip


def normal_form(formula: f.Formula, *, negated: bool = False) -> f.Formula:
    """`formula`, or `not formula`, in normal form."""
    match formula:
        case f.Truth(value):
            return f.Truth(value != negated)
        case f.Comparison(op, left, right):
            return f.Comparison(_OPPOSITE[op], left, right) if negated else formula
        case f.Not(operand):
            return normal_form(operand, negated=not negated)
        case f.And(operands) | f.Or(operands):
            conjunctive = isinstance(formula, f.And) != negated
            parts = (normal_form(operand, negated=negated) for operand in operands)
            return _joined(f.And if conjunctive else f.Or, parts)
        case f.Implies() | f.Iff() | f.Xor():
            return normal_form(_spelled_out(formula), negated=negated)
        case f.Until(interval, left, right) | f.Since(interval, left, right):
            plain = type(formula)(interval, normal_form(left), normal_form(right))
            return f.Not(plain) if negated else plain
        case f.Always(interval, operand) | f.Eventually(interval, operand):
            least = isinstance(formula, f.Always) != negated
            return (f.Always if least else f.Eventually)(
                interval, normal_form(operand, negated=negated)
            )
        case f.Historically(interval, operand) | f.Once(interval, operand):
            least = isinstance(formula, f.Historically) != negated
            return (f.Historically if least else f.Once)(
                interval, normal_form(operand, negated=negated)
            )
    raise TypeError(f"not a formula: {formula!r}")


def _spelled_out(formula: f.Implies | f.Iff | f.Xor) -> f.Formula:
    left, right = formula.left, formula.right
    if isinstance(formula, f.Implies):
        return f.Or((f.Not(left), right))
    if isinstance(formula, f.Iff):
        return f.And((f.Or((f.Not(left), right)), f.Or((f.Not(right), left))))
    return f.Or((f.And((left, f.Not(right))), f.And((f.Not(left), right))))


def _joined(kind: type[f.And] | type[f.Or], parts: Iterable[f.Formula]) -> f.Formula:
    """Nested conjunctions and disjunctions flattened, repeats dropped, order kept."""
    flat: dict[f.Formula, None] = {}
    for part in parts:
        flat.update(dict.fromkeys(part.operands if isinstance(part, kind) else (part,)))
    return next(iter(flat)) if len(flat) == 1 else kind(tuple(flat))
