"""STL formulas: the one type that scene files, the library and every report share.

How an operator is written is in `roadlang.syntax.operators`, found by its `word`.
"""

from __future__ import annotations

from collections.abc import Sequence

from .interval import UNBOUNDED, Interval
from .made_of import ComparisonOperator
from .measures import AtLeast, Count, Duration, Measured
from .shapes import (
    BinaryTemporal,
    Comparison,
    Compound,
    Connective,
    Derived,
    Formula,
    LogicalJunction,
    Not,
    Pointwise,
    SampleStep,
    TemporalOperator,
    Truth,
    TruthChange,
    UnaryTemporal,
)

__all__ = [
    "COMPOUNDS",
    "Always",
    "And",
    "AtLeast",
    "BinaryTemporal",
    "Comparison",
    "ComparisonOperator",
    "Compound",
    "Connective",
    "Count",
    "Derived",
    "Duration",
    "Eventually",
    "Fall",
    "Formula",
    "Historically",
    "Iff",
    "Implies",
    "LogicalJunction",
    "Measured",
    "Next",
    "Not",
    "Once",
    "Or",
    "PastRelease",
    "Pointwise",
    "Prev",
    "Release",
    "Rise",
    "SampleStep",
    "Since",
    "TemporalOperator",
    "Truth",
    "TruthChange",
    "UnaryTemporal",
    "Until",
    "WeakSince",
    "WeakUntil",
    "Xor",
    "compound",
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


class Release(BinaryTemporal, Derived):
    """`not (not left until not right)`: `right` at every sample of the window, up to and with the
    first one that `left` holds at, or held at before."""

    __slots__ = ()
    word = "release"
    past = False

    def expanded(self, *, greatest: bool = False) -> Formula:
        """Written with `not` and `until`."""
        return Not(Until(self.interval, Not(self.left), Not(self.right)))


class PastRelease(BinaryTemporal, Derived):
    """`not (not left since not right)`: release, looking back."""

    __slots__ = ()
    word = "trigger"
    past = True

    def expanded(self, *, greatest: bool = False) -> Formula:
        """Written with `not` and `since`."""
        return Not(Since(self.interval, Not(self.left), Not(self.right)))


class WeakUntil(BinaryTemporal, Derived):
    """`left until right`, or `left` to the end of the interval."""

    __slots__ = ()
    word = "weak_until"
    past = False

    def expanded(self, *, greatest: bool = False) -> Formula:
        """By `or`, `until` and `always`."""
        to_end = Interval(0.0, (self.interval or UNBOUNDED).hi)
        return Or((Until(self.interval, self.left, self.right), Always(to_end, self.left)))


class WeakSince(BinaryTemporal, Derived):
    """`left since right`, or `left` back to the far end of the interval."""

    __slots__ = ()
    word = "weak_since"
    past = True

    def expanded(self, *, greatest: bool = False) -> Formula:
        """By `or`, `since` and `historically`."""
        to_end = Interval(0.0, (self.interval or UNBOUNDED).hi)
        return Or((Since(self.interval, self.left, self.right), Historically(to_end, self.left)))


class Next(SampleStep):
    """The operand at the next sample; false at the last one."""

    __slots__ = ()
    word = "next"
    past = False


class Prev(SampleStep):
    """The operand at the previous sample; false at the first one."""

    __slots__ = ()
    word = "prev"
    past = True


class Rise(TruthChange):
    """The operand holds and did not at the sample before, if there is one."""

    __slots__ = ()
    word = "rise"

    def expanded(self, *, greatest: bool = False) -> Formula:
        """By `not`, `and` and `prev`."""
        return And((self.operand, Not(Prev(None, self.operand))))


class Fall(TruthChange):
    """The operand fails and did not at the sample before, if there is one."""

    __slots__ = ()
    word = "fall"

    def expanded(self, *, greatest: bool = False) -> Formula:
        """By `not`, `and` and `prev`."""
        return And((Not(self.operand), Not(Prev(None, Not(self.operand)))))


COMPOUNDS: dict[str, type[Compound]] = {
    kind.word: kind
    for kind in (
        Not, And, Or, Implies, Iff, Xor, Always, Eventually, Historically, Once, Until, Since,
        Release, PastRelease, WeakUntil, WeakSince, Next, Prev, Rise, Fall,
        Count, Duration,
    )
}  # fmt: skip
"""The operators by their words."""


def compound(word: str, parts: Sequence[Formula], interval: Interval | None = None) -> Formula:
    """The formula that the operator `word` makes of `parts`.

    Raises KeyError for a word that is no operator, TypeError for another number of parts.
    """
    return COMPOUNDS[word].of(parts, interval)
