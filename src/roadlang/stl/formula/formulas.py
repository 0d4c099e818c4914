"""STL formulas: the one type that scene files, the library and every report share.

How an operator is written is in `roadlang.syntax.operators`, found by its `word`.
"""

from __future__ import annotations

from collections.abc import Sequence

from .interval import Interval
from .shapes import (
    BinaryTemporal,
    Comparison,
    ComparisonOperator,
    Compound,
    Connective,
    Derived,
    Formula,
    LogicalJunction,
    Not,
    Pointwise,
    TemporalOperator,
    Truth,
    UnaryTemporal,
)

__all__ = [
    "COMPOUNDS", "Always", "And", "BinaryTemporal", "Comparison", "ComparisonOperator", "Compound",
    "Connective", "Derived", "Eventually", "Formula", "Historically", "Iff", "Implies",
    "LogicalJunction", "Not", "Once", "Or", "Pointwise", "Since", "TemporalOperator", "Truth",
    "UnaryTemporal", "Until", "Xor", "compound",
]  # fmt: skip


class And(LogicalJunction):
    """The least of its operands; `And(())` is true."""

    __slots__ = ()
    word = "and"
    least = True


class Or(LogicalJunction):
    """The greatest of its operands; `Or(())` is false."""

    __slots__ = ()
    word = "or"
    least = False


class Implies(Connective):
    """`not left or right`."""

    __slots__ = ()
    word = "implies"
    directions = (-1, 1)

    def expanded(self, *, greatest: bool = False) -> Formula:
        """By `not`, `and` and `or`."""
        return Or((Not(self.left), self.right))


class Iff(Connective):
    """`(left implies right) and (right implies left)`."""

    __slots__ = ()
    word = "iff"
    directions = (0, 0)

    def expanded(self, *, greatest: bool = False) -> Formula:
        """By `not`, `and` and `or`."""
        return _both_or_neither(self.left, self.right, greatest)


class Xor(Connective):
    """`(left and not right) or (not left and right)`."""

    __slots__ = ()
    word = "xor"
    directions = (0, 0)

    def expanded(self, *, greatest: bool = False) -> Formula:
        """By `not`, `and` and `or`."""
        return _both_or_neither(self.left, Not(self.right), greatest)


def _both_or_neither(left: Formula, right: Formula, greatest: bool) -> Formula:
    if greatest:
        return Or((And((left, right)), And((Not(left), Not(right)))))
    return And((Or((Not(left), right)), Or((left, Not(right)))))


class Always(UnaryTemporal):
    """The least of the operand over the samples in `t + interval` (None: to the end)."""

    __slots__ = ()
    word = "always"
    least, past = True, False


class Eventually(UnaryTemporal):
    """The greatest of the operand over the samples in `t + interval` (None: to the end)."""

    __slots__ = ()
    word = "eventually"
    least, past = False, False


class Historically(UnaryTemporal):
    """The least of the operand over the samples in `t - interval` (None: from the start)."""

    __slots__ = ()
    word = "historically"
    least, past = True, True


class Once(UnaryTemporal):
    """The greatest of the operand over the samples in `t - interval` (None: from the start)."""

    __slots__ = ()
    word = "once"
    least, past = False, True


class Until(BinaryTemporal):
    """`right` at some witness t' in `t + interval`, `left` at every sample of [t, t')."""

    __slots__ = ()
    word = "until"
    past = False


class Since(BinaryTemporal):
    """`right` at some witness t' in `t - interval`, `left` at every sample of (t', t]."""

    __slots__ = ()
    word = "since"
    past = True


COMPOUNDS: dict[str, type[Compound]] = {
    kind.word: kind
    for kind in (
        Not, And, Or, Implies, Iff, Xor, Always, Eventually, Historically, Once, Until, Since,
    )
}  # fmt: skip
"""The operators by their words."""


def compound(word: str, parts: Sequence[Formula], interval: Interval | None = None) -> Formula:
    """The formula that the operator `word` makes of `parts`.

    Raises KeyError for a word that is no operator, TypeError for another number of parts.
    """
    return COMPOUNDS[word].of(parts, interval)
