"""Terms of STL: real numbers computed sample by sample from named signals."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias

from ...syntax.words import NOT_NAMES

ArithmeticOperator: TypeAlias = Literal["+", "-", "*", "/", "^"]
FunctionName: TypeAlias = Literal["abs", "min", "max"]

_LEVEL = {"^": 4, "*": 2, "/": 2, "+": 1, "-": 1}
_ATOM = 9
_CALL = re.compile(r"[A-Za-z_][\w.]*\(.*\)\Z")
_WORD = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")


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
        return _text(self, 0)


@dataclass(frozen=True, slots=True)
class Constant(Term):
    """The same number at every sample, in the unit of the other side of the comparison."""

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


def name_text(name: str) -> str:
    """A name as formulas have it: in back quotes where it is no word that could be a signal.

    Signals of scenes are named as they are written there: `curvature(main)`.
    """
    first, *members = name.split(".")
    is_plain = _WORD.match(first) and first not in NOT_NAMES and all(map(_WORD.match, members))
    return name if is_plain or _CALL.match(name) else f"`{name}`"


def number_text(value: float) -> str:
    """The shortest text that reads back as `value`: `10`, `0.1`, `1e-07`, `inf`."""
    value = float(value)
    return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)


def _text(term: Term, outer: int) -> str:
    """Parentheses only where the precedence of the language needs them."""
    match term:
        case Constant(value):
            text, level = number_text(value), 3 if value < 0 else _ATOM
        case Variable(name):
            text, level = name_text(name), _ATOM
        case Negate(operand):
            text, level = f"-{_text(operand, 4)}", 3
        case Apply(function, arguments):
            text = f"{function}({', '.join(_text(argument, 0) for argument in arguments)})"
            level = _ATOM
        case Arithmetic(op, left, right):
            level = _LEVEL[op]
            near, far = (level + 1, level + 1) if op == "^" else (level, level + 1)
            text = f"{_text(left, near)} {op} {_text(right, far)}"
        case _:
            raise TypeError(f"not a term: {term!r}")
    return text if level >= outer else f"({text})"
