"""STL formulas: the one type that scene files, the library and every report share."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias

from .evaluable import Evaluable
from .interval import Interval
from .terms import Term

ComparisonOperator: TypeAlias = Literal["<", "<=", ">", ">=", "==", "!="]


class Formula(Evaluable):
    """A statement about a trace; `str(formula)` is its canonical text."""

    __slots__ = ()

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The formulas this one is made of, left to right."""
        return ()

    @property
    def variables(self) -> frozenset[str]:
        """Names of the signals the formula reads."""
        comparisons = (node for node in self.walk() if isinstance(node, Comparison))
        return frozenset().union(*(c.left.variables | c.right.variables for c in comparisons))

    @property
    def temporal(self) -> bool:
        """Whether a temporal operator occurs anywhere in the formula."""
        return any(isinstance(node, TEMPORAL) for node in self.walk())

    def walk(self) -> Iterator[Formula]:
        """This formula and all below it, parents first."""
        yield self
        for part in self.parts:
            yield from part.walk()

    def __str__(self) -> str:
        from .printing import formula_text

        return formula_text(self)


@dataclass(frozen=True, slots=True)
class Truth(Formula):
    """`true` or `false`: robustness plus or minus infinity."""

    value: bool


@dataclass(frozen=True, slots=True)
class Comparison(Formula):
    """`left op right`; strictness matters to Boolean evaluation only, not to robustness."""

    op: ComparisonOperator
    left: Term
    right: Term


@dataclass(frozen=True, slots=True)
class _Unary(Formula):
    operand: Formula

    @property
    def parts(self) -> tuple[Formula, ...]:
        return (self.operand,)


@dataclass(frozen=True, slots=True)
class _Nary(Formula):
    operands: tuple[Formula, ...]

    @property
    def parts(self) -> tuple[Formula, ...]:
        return self.operands


@dataclass(frozen=True, slots=True)
class _Binary(Formula):
    left: Formula
    right: Formula

    @property
    def parts(self) -> tuple[Formula, ...]:
        return (self.left, self.right)


@dataclass(frozen=True, slots=True)
class _TemporalUnary(Formula):
    interval: Interval | None
    operand: Formula

    @property
    def parts(self) -> tuple[Formula, ...]:
        return (self.operand,)


@dataclass(frozen=True, slots=True)
class _TemporalBinary(Formula):
    interval: Interval | None
    left: Formula
    right: Formula

    @property
    def parts(self) -> tuple[Formula, ...]:
        return (self.left, self.right)


class Not(_Unary):
    """Robustness with its sign turned."""

    __slots__ = ()


class And(_Nary):
    """The least of its operands; `And(())` is true."""

    __slots__ = ()


class Or(_Nary):
    """The greatest of its operands; `Or(())` is false."""

    __slots__ = ()


class Implies(_Binary):
    """`not left or right`."""

    __slots__ = ()


class Iff(_Binary):
    """`(left implies right) and (right implies left)`."""

    __slots__ = ()


class Xor(_Binary):
    """`(left and not right) or (not left and right)`."""

    __slots__ = ()


class Always(_TemporalUnary):
    """The least of the operand over the samples in `t + interval` (None: to the end)."""

    __slots__ = ()


class Eventually(_TemporalUnary):
    """The greatest of the operand over the samples in `t + interval` (None: to the end)."""

    __slots__ = ()


class Once(_TemporalUnary):
    """The greatest of the operand over the samples in `t - interval` (None: from the start)."""

    __slots__ = ()


class Historically(_TemporalUnary):
    """The least of the operand over the samples in `t - interval` (None: from the start)."""

    __slots__ = ()


class Until(_TemporalBinary):
    """`right` at some witness t' in `t + interval`, `left` at every sample of [t, t')."""

    __slots__ = ()


class Since(_TemporalBinary):
    """`right` at some witness t' in `t - interval`, `left` at every sample of (t', t]."""

    __slots__ = ()


TEMPORAL = (_TemporalUnary, _TemporalBinary)
FUTURE = (Always, Eventually, Until)
PAST = (Once, Historically, Since)
