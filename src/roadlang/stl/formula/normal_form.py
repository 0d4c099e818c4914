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


def normal_form(formula: f.Formula, *, negated: bool = False, greatest: bool = False) -> f.Formula:
    """`formula`, or `not formula`, in normal form.

    `iff` and `xor` become a least of greatests, or a `greatest` of leasts. They are worth the same,
    but the one gives the better lower, the other the better upper bound from bounds of the parts.
    """

    def of(part: f.Formula, negated: bool = negated) -> f.Formula:
        return normal_form(part, negated=negated, greatest=greatest)

    match formula:
        case f.Truth(value):
            return f.Truth(value != negated)
        case f.Comparison(op, left, right):
            return f.Comparison(_OPPOSITE[op], left, right) if negated else formula
        case f.Not(operand):
            return of(operand, not negated)
        case f.And(operands) | f.Or(operands):
            conjunctive = isinstance(formula, f.And) != negated
            parts = (of(operand) for operand in operands)
            return _joined(f.And if conjunctive else f.Or, parts)
        case f.Implies() | f.Iff() | f.Xor():
            return of(_spelled_out(formula, greatest != negated))
        case f.Until(interval, left, right) | f.Since(interval, left, right):
            sides = [normal_form(side, greatest=greatest != negated) for side in (left, right)]
            plain = type(formula)(interval, *sides)
            return f.Not(plain) if negated else plain
        case f.Always(interval, operand) | f.Eventually(interval, operand):
            least = isinstance(formula, f.Always) != negated
            return (f.Always if least else f.Eventually)(interval, of(operand))
        case f.Historically(interval, operand) | f.Once(interval, operand):
            least = isinstance(formula, f.Historically) != negated
            return (f.Historically if least else f.Once)(interval, of(operand))
    raise TypeError(f"not a formula: {formula!r}")


def _spelled_out(formula: f.Implies | f.Iff | f.Xor, greatest: bool) -> f.Formula:
    left, right = formula.left, formula.right
    if isinstance(formula, f.Implies):
        return f.Or((f.Not(left), right))
    other = right if isinstance(formula, f.Iff) else f.Not(right)
    if greatest:
        return f.Or((f.And((left, other)), f.And((f.Not(left), f.Not(other)))))
    return f.And((f.Or((f.Not(left), other)), f.Or((left, f.Not(other)))))


def _joined(kind: type[f.And] | type[f.Or], parts: Iterable[f.Formula]) -> f.Formula:
    """Nested conjunctions and disjunctions flattened, repeats dropped, order kept."""
    flat: dict[f.Formula, None] = {}
    for part in parts:
        flat.update(dict.fromkeys(part.operands if isinstance(part, kind) else (part,)))
    return next(iter(flat)) if len(flat) == 1 else kind(tuple(flat))
