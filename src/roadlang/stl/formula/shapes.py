"""What formulas are: true or false, comparisons, and the shapes of the operators that join them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from ...syntax.operators import BY_WORD, Operator
from .evaluable import Evaluable
from .interval import UNBOUNDED, Interval, NeighborWindow, Reach
from .made_of import ComparisonOperator, checked_interval, checked_part, checked_sides
from .terms import Term

if TYPE_CHECKING:
    from typing_extensions import Self


class Formula(Evaluable):
    """A statement about a trace; `str(formula)` is its canonical text."""

    __slots__ = ("_variables",)
    _variables: frozenset[str]

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The formulas this one is made of, left to right."""
        return ()

    @property
    def variables(self) -> frozenset[str]:
        """Names of the signals the formula reads."""
        if not hasattr(self, "_variables"):
            sides = [checked_sides(c) for c in self.walk() if isinstance(c, Comparison)]
            names = frozenset(name for pair in sides for side in pair for name in side.variables)
            object.__setattr__(self, "_variables", names)
        return self._variables

    @property
    def temporal(self) -> bool:
        """Whether a temporal operator occurs anywhere in the formula."""
        return any(isinstance(node, TemporalOperator) for node in self.walk())

    @property
    def looks_ahead(self) -> bool:
        """Whether an operator looks ahead."""
        return any(isinstance(node, TemporalOperator) and not node.past for node in self.walk())

    @property
    def looks_back(self) -> bool:
        """Whether an operator looks back."""
        return any(isinstance(node, TemporalOperator) and node.past for node in self.walk())

    def walk(self) -> Iterator[Formula]:
        """This formula and all below it, parents first."""
        yield self
        for part in self.parts:
            yield from checked_part(self, part, Formula).walk()


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


class Compound(Formula):
    """A formula that an operator makes of others."""

    __slots__ = ()
    word: ClassVar[str]

    @property
    def notation(self) -> Operator:
        """How the operator is written."""
        return BY_WORD[self.word]

    @property
    def window(self) -> Interval | None:
        """The interval of a temporal operator; None without one, and for other operators."""
        return None

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """The formula that the operator makes. Raises TypeError for another number of parts."""
        raise NotImplementedError

    def with_parts(self, parts: Sequence[Formula]) -> Self:
        """The same operator, with the same interval, of other parts."""
        return self.of(parts, self.window)


class Pointwise(Compound):
    """An operator whose value at a sample is that of its parts at the same sample.

    `trends` of the parts: +1 where the robustness is that of the part or of another, -1 with the
    sign turned, 0 where it may be either.
    """

    __slots__ = ()

    @property
    def trends(self) -> tuple[int, ...]:
        """How the robustness moves with each part."""
        raise NotImplementedError


@dataclass(frozen=True, slots=True)
class TemporalOperator(Compound):
    """An operator over the samples in an interval (None: all), ahead or in the past (`past`)."""

    interval: Interval | None
    past: ClassVar[bool]

    def __post_init__(self) -> None:
        if checked_interval(self.interval) == UNBOUNDED:  # `always[0, inf] p` is `always p`
            object.__setattr__(self, "interval", None)

    @property
    def window(self) -> Interval | None:
        """The interval, None for all later (or earlier) samples."""
        return self.interval

    @property
    def reach(self) -> Reach:
        """Which samples the operator looks at."""
        return self.interval


class Derived(Compound):
    """An operator that others can express: it needs no kernel of its own."""

    __slots__ = ()

    def expanded(self, *, greatest: bool = False) -> Formula:
        """The same by other operators; with `greatest`, of two equal forms the greatest of leasts,
        which gives better upper bounds from bounds of the parts, as the other does lower ones."""
        raise NotImplementedError


@dataclass(frozen=True, slots=True)
class Not(Pointwise):
    """Robustness with its sign turned."""

    operand: Formula
    word = "not"

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return (self.operand,)

    @property
    def trends(self) -> tuple[int, ...]:
        """How the robustness moves with each part."""
        return (-1,)

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """The formula of these parts."""
        return cls(*parts)


@dataclass(frozen=True, slots=True)
class LogicalJunction(Pointwise):
    """The least or the greatest of any number of operands."""

    operands: tuple[Formula, ...]
    least: ClassVar[bool]

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return self.operands

    @property
    def trends(self) -> tuple[int, ...]:
        """How the robustness moves with each part."""
        return (1,) * len(self.operands)

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """The formula of these parts."""
        return cls(tuple(parts))


@dataclass(frozen=True, slots=True)
class Connective(Pointwise, Derived):
    """Two operands joined in a way that `not`, `and` and `or` can express."""

    left: Formula
    right: Formula
    directions: ClassVar[tuple[int, int]]

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return (self.left, self.right)

    @property
    def trends(self) -> tuple[int, ...]:
        """How the robustness moves with each part."""
        return self.directions

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """The formula of these parts."""
        return cls(*parts)


@dataclass(frozen=True, slots=True)
class UnaryTemporal(TemporalOperator):
    """The least or the greatest of the operand in a window (None: as far as the trace goes)."""

    operand: Formula
    least: ClassVar[bool]

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return (self.operand,)

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """The formula of these parts."""
        return cls(interval, *parts)


@dataclass(frozen=True, slots=True)
class BinaryTemporal(TemporalOperator):
    """`right` at a witness in the window, `left` at every sample on the way to it."""

    left: Formula
    right: Formula

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return (self.left, self.right)

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """The formula of these parts."""
        return cls(interval, *parts)


@dataclass(frozen=True, slots=True)
class SampleStep(TemporalOperator):
    """The operand at the neighboring sample; false where there is none. It has no interval."""

    operand: Formula

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return (self.operand,)

    @property
    def reach(self) -> Reach:
        """Which samples the operator looks at."""
        return NeighborWindow()

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """The formula of these parts; TypeError with an interval."""
        return cls(_none(interval), *parts)


@dataclass(frozen=True, slots=True)
class TruthChange(TemporalOperator, Derived):
    """Whether the operand has just changed, from one sample to the next. It has no interval."""

    operand: Formula
    past: ClassVar[bool] = True

    @property
    def parts(self) -> tuple[Formula, ...]:
        """The operands, left to right."""
        return (self.operand,)

    @classmethod
    def of(cls, parts: Sequence[Formula], interval: Interval | None = None) -> Self:
        """The formula of these parts; TypeError with an interval."""
        return cls(_none(interval), *parts)


def _none(interval: Interval | None) -> Interval | None:
    if interval is not None:
        raise TypeError("this operator has no interval")
    return interval
