"""What is known of a formula before its signals are: from the bounds of its variables alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce
from typing import Any, TypeAlias

from ..formula import formulas as f
from .interval_arithmetic import Bounds, term_bounds

Flags: TypeAlias = Any
"""A bool, or an array of them with one for each variant"""


@dataclass(frozen=True, slots=True)
class StaticTruth:
    """`certain`: satisfied by all values within the bounds; `possible`: not known to be violated
    by all of them. Both are Boolean semantics: `<` and `<=` differ where bounds touch."""

    certain: Flags
    possible: Flags


def static_truth(formula: f.Formula, variables: Mapping[str, Bounds]) -> StaticTruth:
    """What all traces of one sample or more say of a formula at their first sample.

    `variables` are least and greatest values of signals, at every sample; of others nothing is
    known. The same variable in two comparisons is taken for two.
    """
    known: dict[int, tuple[f.Formula, StaticTruth]] = {}

    def of(part: f.Formula) -> StaticTruth:
        # By identity: formulas share parts, and equality would look at a shared part again.
        if id(part) not in known:
            known[id(part)] = part, compute(part)
        return known[id(part)][1]

    def compute(part: f.Formula) -> StaticTruth:
        match part:
            case f.Truth(value):
                return StaticTruth(value, value)
            case f.Comparison(op, left, right):
                sides = term_bounds(left, variables), term_bounds(right, variables)
                return _COMPARISONS[op](*sides)
            case f.Not(operand):
                return _negated(of(operand))
            case f.Derived():
                return of(part.expanded())
            case f.LogicalJunction(operands):
                join = _both if part.least else _either
                return reduce(join, map(of, operands), StaticTruth(part.least, part.least))
            case f.AtLeast(_, operand):
                return _often_enough(of(operand), part)
            case f.SampleStep(_, operand):
                return StaticTruth(False, of(operand).possible)
            case f.UnaryTemporal(_, operand):
                return _in_window(of(operand), part)
            case f.BinaryTemporal(_, left, right):
                return _with_witness(of(left), of(right), part)
        raise TypeError(f"not a formula: {part!r}")

    return of(formula)


def fails_at_one_sample(formula: f.Formula, variables: Mapping[str, Bounds]) -> bool:
    """Whether a formula is violated by a trace with one sample, anywhere, whose values are within
    the bounds `variables`: of an `always` without an interval, and of what is joined by `and`."""
    match formula:
        case f.And(operands):
            return any(fails_at_one_sample(part, variables) for part in operands)
        case f.Always(None, operand) if not operand.temporal:
            return not static_truth(operand, variables).possible
    return False


def _in_window(operand: StaticTruth, formula: f.UnaryTemporal) -> StaticTruth:
    """A window that holds its own sample is not empty; any other may be, near the end."""
    if _includes_now(formula):
        return operand
    if formula.least:
        return StaticTruth(operand.certain, True)
    return StaticTruth(False, operand.possible)


def _often_enough(operand: StaticTruth, formula: f.AtLeast) -> StaticTruth:
    if formula.is_trivial:
        return StaticTruth(True, True)
    return StaticTruth(False, formula.is_possible and operand.possible)


def _with_witness(left: StaticTruth, right: StaticTruth, formula: f.BinaryTemporal) -> StaticTruth:
    """A witness at its own sample needs nothing of `left`; any other needs `left` there."""
    if _includes_now(formula):
        return right
    return StaticTruth(False, _both(left, right).possible)


def _includes_now(formula: f.UnaryTemporal | f.BinaryTemporal) -> bool:
    return formula.interval is None or formula.interval.lo == 0


def _negated(truth: StaticTruth) -> StaticTruth:
    return StaticTruth(_not(truth.possible), _not(truth.certain))


def _both(a: StaticTruth, b: StaticTruth) -> StaticTruth:
    return StaticTruth(a.certain & b.certain, a.possible & b.possible)


def _either(a: StaticTruth, b: StaticTruth) -> StaticTruth:
    return StaticTruth(a.certain | b.certain, a.possible | b.possible)


def _not(flags: Flags) -> Flags:
    return not flags if isinstance(flags, bool) else ~flags


def _less(a: Bounds, b: Bounds) -> StaticTruth:
    return StaticTruth(a[1] < b[0], a[0] < b[1])


def _at_most(a: Bounds, b: Bounds) -> StaticTruth:
    return StaticTruth(a[1] <= b[0], a[0] <= b[1])


def _equal(a: Bounds, b: Bounds) -> StaticTruth:
    return _both(_at_most(a, b), _at_most(b, a))


_COMPARISONS: dict[str, Callable[[Bounds, Bounds], StaticTruth]] = {
    "<": _less,
    "<=": _at_most,
    ">": lambda a, b: _less(b, a),
    ">=": lambda a, b: _at_most(b, a),
    "==": _equal,
    "!=": lambda a, b: _negated(_equal(a, b)),
}
