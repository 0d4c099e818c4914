"""Rewriting that leaves robustness as it is and lets its range see what two parts share.

`always p and eventually q` is worth what `always p and eventually (q and p)` is worth: the witness
of q is one of the samples that the minimum of p is over. Only the latter knows, of a later
sample, that p and q are about the same signals.
"""

from __future__ import annotations

from collections.abc import Sequence

from . import formulas as f
from .interval import UNBOUNDED, Interval
from .normal_form import joined

_Shared = tuple[bool, Interval, f.Formula]
"""Whether it is about the past, the samples it is about, and what holds at all of them."""


def strengthened(formula: f.Formula) -> f.Formula:
    """A formula in normal form with what governs all samples said again where it also counts."""
    match formula:
        case f.LogicalJunction(operands):
            parts = [strengthened(part) for part in operands]
            return type(formula)(_with_shared(parts, type(formula)))
        case f.Compound():
            return formula.with_parts([strengthened(part) for part in formula.parts])
    return formula


def _with_shared(
    parts: Sequence[f.Formula], kind: type[f.LogicalJunction]
) -> tuple[f.Formula, ...]:
    """Add to each part the state formulas that `always` (in `or`: `eventually`) says beside it."""
    shared: list[_Shared] = [
        (part.past, part.interval or UNBOUNDED, part.operand)
        for part in parts
        if isinstance(part, f.UnaryTemporal)
        and part.least == kind.least
        and not part.operand.temporal
    ]
    return tuple(_add(part, shared, kind) for part in parts) if shared else tuple(parts)


def _add(part: f.Formula, shared: Sequence[_Shared], kind: type[f.LogicalJunction]) -> f.Formula:
    match part:
        case f.UnaryTemporal():
            interval = part.interval or UNBOUNDED
            added = _covering(shared, part.past, interval)
            return type(part)(part.interval, joined(kind, (part.operand, *added)))
        case f.BinaryTemporal() if kind.least:
            until_end = Interval(0.0, (part.interval or UNBOUNDED).hi)
            added = _covering(shared, part.past, until_end)
            left, right = (joined(kind, (side, *added)) for side in (part.left, part.right))
            return type(part)(part.interval, left, right)
        case _ if not part.temporal:
            now = Interval(0.0, 0.0)
            added = [*_covering(shared, False, now), *_covering(shared, True, now)]
            return joined(kind, (part, *added))
    return part


def _covering(shared: Sequence[_Shared], past: bool, interval: Interval) -> list[f.Formula]:
    """What holds at all samples of `interval`, on the same side of the present."""
    return [
        state
        for about_past, known, state in shared
        if about_past == past and known.lo <= interval.lo and interval.hi <= known.hi
    ]
