"""Formulas in the few operators that the kernels know, negations pushed to the comparisons.

The rewriting changes neither robustness (to the last bit: x - y and -(y - x) round equally), nor
Boolean satisfaction. What remains: Truth, Comparison, And, Or, the temporal operators, and Not in
front of until, since, next, prev and "at least so often", which have no dual here.
"""

from __future__ import annotations

from collections.abc import Iterable

from . import formulas as f

_OPPOSITE: dict[f.ComparisonOperator, f.ComparisonOperator] = {
    "<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "==",
}  # fmt: skip
_DUAL: dict[type[f.Compound], type[f.Compound]] = {
    f.And: f.Or, f.Always: f.Eventually, f.Historically: f.Once,
}  # fmt: skip
_DUAL |= {dual: kind for kind, dual in _DUAL.items()}


def normal_form(formula: f.Formula, *, negated: bool = False, greatest: bool = False) -> f.Formula:
    """`formula`, or `not formula`, in normal form.

    What has two forms (`iff`, `xor`) becomes a least of greatests, or a `greatest` of leasts.
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
        case f.Derived():
            return of(formula.expanded(greatest=greatest != negated))
        case f.LogicalJunction(operands):
            kind = _DUAL[type(formula)] if negated else type(formula)
            return joined(kind, (of(operand) for operand in operands))
        case f.AtLeast() if (simple := _simple(formula)) is not None:
            return of(simple)
        case f.BinaryTemporal() | f.SampleStep() | f.AtLeast():
            parts = [normal_form(part, greatest=greatest != negated) for part in formula.parts]
            plain = formula.with_parts(parts)
            return f.Not(plain) if negated else plain
        case f.UnaryTemporal(interval, operand):
            kind = _DUAL[type(formula)] if negated else type(formula)
            return kind.of([of(operand)], interval)
    raise TypeError(f"not a formula: {formula!r}")


def _simple(formula: f.AtLeast) -> f.Formula | None:
    """What another operator says as well: nothing is asked for, or one sample."""
    if formula.is_trivial:
        return f.Truth(True)
    once = formula.counts and formula.samples == 1
    return f.Eventually(formula.interval, formula.operand) if once else None


def joined(kind: type[f.Compound], parts: Iterable[f.Formula]) -> f.Formula:
    """A conjunction or disjunction: nested ones flattened, repeats dropped, order kept."""
    flat: dict[f.Formula, None] = {}
    for part in parts:
        flat.update(dict.fromkeys(part.parts if isinstance(part, kind) else (part,)))
    return next(iter(flat)) if len(flat) == 1 else kind.of(tuple(flat))
