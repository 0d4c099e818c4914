"""Terms of STL: real numbers computed sample by sample from named signals."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias

ArithmeticOperator: TypeAlias = Literal["+", "-", "*", "/", "^"]
FunctionName: TypeAlias = Literal["abs", "min", "max"]


class Term:
    """A real number at every sample; `str(term)` is its canonical text."""

    __slots__ = ()

    @property
    def parts(self) -> tuple[Term, ...]:
        """The terms this one is made of, left to right."""
        return ()

    @property
    def variables(self) -> frozenset[str]:
        """Names of the signals the term reads."""
        return frozenset(term.name for term in self.walk() if isinstance(term, Variable))

    def walk(self) -> Iterator[Term]:
        """This term and all below it, parents first."""
        yield self
        for part in self.parts:
            yield from part.walk()

    def __str__(self) -> str:
        from .printing import term_text

        return term_text(self)


@dataclass(frozen=True, slots=True)
class Constant(Term):
    """The same number at every sample, in the units of what it is compared with."""

    value: float


@dataclass(frozen=True, slots=True)
class Variable(Term):
    """A signal looked up by name when the formula is evaluated."""

    name: str


@dataclass(frozen=True, slots=True)
class Negate(Term):
    """Minus its operand."""

    operand: Term

    @property
    def parts(self) -> tuple[Term, ...]:
        """The operands, left to right."""
        return (self.operand,)


@dataclass(frozen=True, slots=True)
class Arithmetic(Term):
    """`left op right` for one of `+ - * / ^`."""

    op: ArithmeticOperator
    left: Term
    right: Term

    @property
    def parts(self) -> tuple[Term, ...]:
        """The operands, left to right."""
        return (self.left, self.right)


@dataclass(frozen=True, slots=True)
class Apply(Term):
    """`abs`, `min` or `max` of its arguments, sample by sample."""

    function: FunctionName
    arguments: tuple[Term, ...]

    @property
    def parts(self) -> tuple[Term, ...]:
        """The operands, left to right."""
        return self.arguments
