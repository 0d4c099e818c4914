"""How often, or for how long, a formula holds in a window, compared with a number.

Robustness is an order statistic: that of `count (p) >= 3` is the third greatest value of p in the
window, the greatest level that p reaches at three samples. A duration is the same with samples that
are weighted by the time until the next one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal, TypeAlias

from .interval import Interval
from .shapes import Derived, Formula, Not, TemporalOperator

if TYPE_CHECKING:
    from typing_extensions import Self

MeasureComparison: TypeAlias = Literal["<", "<=", ">", ">="]
MIRRORED: dict[str, MeasureComparison] = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
"""The comparison with its sides exchanged."""


@dataclass(frozen=True, slots=True)
class Measured(TemporalOperator, Derived):
    """`word[a, b] (operand) op amount`."""

    operand: Formula
    op: MeasureComparison
    amount: float
    past: ClassVar[bool] = False
    counts: ClassVar[bool]

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return (self.operand,)

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """Raises TypeError: the parts do not tell what to compare with."""
        raise TypeError("this operator needs a comparison with a number")

    def with_parts(self, parts: Sequence[Formula]) -> Self:
        """The same formula with other operands."""
        (operand,) = parts
        return replace(self, operand=operand)

    def expanded(self, *, greatest: bool = False) -> Formula:
        """Written with "at least" or "more than", and `not`."""
        more = AtLeast(
            self.interval, self.operand, self.amount, self.op in (">", "<="), self.counts
        )
        return more if self.op in (">", ">=") else Not(more)


class Count(Measured):
    """At how many samples of the window the operand holds."""

    __slots__ = ()
    word = "count"
    counts = True


class Duration(Measured):
    """For how long the operand holds in the window: each sample in it counts from its position to
    that of the next one, or to the end of the window."""

    __slots__ = ()
    word = "duration"
    counts = False


@dataclass(frozen=True, slots=True)
class AtLeast(TemporalOperator):
    """The operand holds at `amount` samples (`counts`), or for so long, or (`strict`) more."""

    operand: Formula
    amount: float
    strict: bool
    counts: bool
    past: ClassVar[bool] = False

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return (self.operand,)

    @property
    def measured(self) -> Measured:
        """As it is written."""
        kind = Count if self.counts else Duration
        return kind(self.interval, self.operand, ">" if self.strict else ">=", self.amount)

    def with_parts(self, parts: Sequence[Formula]) -> Self:
        """The same formula with other operands."""
        (operand,) = parts
        return replace(self, operand=operand)

    @property
    def is_trivial(self) -> bool:
        """Whether nothing is asked for."""
        return self.amount < 0 or (self.amount == 0 and not self.strict)

    @property
    def is_possible(self) -> bool:
        """Whether the window can be long enough."""
        if self.counts or self.interval is None:
            return True
        longest = self.interval.hi - self.interval.lo
        return self.amount < longest or (self.amount == longest and not self.strict)

    @property
    def samples(self) -> float:
        """Of a count: the least number of samples that are enough."""
        return math.floor(self.amount) + 1 if self.strict else math.ceil(self.amount)
