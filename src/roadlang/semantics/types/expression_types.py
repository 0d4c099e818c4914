"""The types of expressions, and what the checker knows of one: its type, value and bounds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from ...diagnostics import Span
from ...ir.dimension import PURE, Dimension
from ...ir.values import NumberBinding, SignalBinding, Value
from ...stl.evaluate.interval_arithmetic import UNKNOWN, Bounds
from ...stl.formula.formulas import Formula
from ...stl.formula.terms import Term


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number. `fits_any`: a bare 0 or `inf`; `bare`: written without a unit."""

    dimension: Dimension = PURE
    fits_any: bool = False
    bare: bool = False
    is_integer: bool = False

    def __str__(self) -> str:
        return "a number" if self.fits_any else str(self.dimension)


@dataclass(frozen=True, slots=True)
class PlainType:
    """A type of which nothing more is to be said; those that derive from it add no fields."""


class BooleanType(PlainType):
    """`true` or `false`."""

    __slots__ = ()

    def __str__(self) -> str:
        return "`true` or `false`"


@dataclass(frozen=True, slots=True)
class StringType:
    """A string or a word. `values`: all that it can be, where that is known."""

    values: frozenset[str] | None = None
    word: bool = False

    def __str__(self) -> str:
        return "a word" if self.word else "a string"


class CoordinatesType(PlainType):
    """`(x, y)`."""

    __slots__ = ()

    def __str__(self) -> str:
        return "a point"


class SequenceType(PlainType):
    """`[a, b]`."""

    __slots__ = ()

    def __str__(self) -> str:
        return "a list"


class MappingType(PlainType):
    """`{ key: value }`."""

    __slots__ = ()

    def __str__(self) -> str:
        return "a map"


@dataclass(frozen=True, slots=True)
class DeclaredType:
    """A declared thing: `role` is its statement word."""

    role: str

    def __str__(self) -> str:
        return f"{'an' if self.role[0] in 'aeio' else 'a'} {self.role}"


@dataclass(frozen=True, slots=True)
class ConstraintType:
    """The name of a `require` or `expect`."""

    word: str

    def __str__(self) -> str:
        return "a requirement" if self.word == "require" else "an expectation"


@dataclass(frozen=True, slots=True)
class SignalType:
    """A number at every place of a road, or at every time of a drive."""

    domain: str
    dimension: Dimension
    is_integer: bool = False

    def __str__(self) -> str:
        return f"a {self.domain} signal"


@dataclass(frozen=True, slots=True)
class FormulaType:
    """True or false, at every place or time. `domain`: "road", "drive", "scene" (numbers alone)."""

    domain: str

    def __str__(self) -> str:
        return "a formula"


@dataclass(frozen=True, slots=True)
class KindCallType:
    """The call of a kind: a piece, a selector, an agent or object kind."""

    verb: str

    def __str__(self) -> str:
        nouns = {
            "piece": "a piece of a road",
            "select": "a way to choose a road",
            "region": "a region",
            "lane": "a lane",
            "position": "a position",
        }
        return nouns.get(self.verb, f"a kind of {self.verb}")


class Unknown(PlainType):
    """The type of what has already been reported: it fits everywhere, so that nothing is reported
    twice."""

    __slots__ = ()

    def __str__(self) -> str:
        return "unknown"


Type: TypeAlias = (
    Quantity
    | BooleanType
    | StringType
    | CoordinatesType
    | SequenceType
    | MappingType
    | DeclaredType
    | ConstraintType
    | SignalType
    | FormulaType
    | KindCallType
    | Unknown
)


@dataclass(frozen=True, slots=True)
class DomainEvidence:
    """Which domain an expression has, and the place that says so."""

    domain: str
    span: Span
    text: str


@dataclass(frozen=True, slots=True)
class TypedExpression:
    """An expression that was looked at.

    `value` is set for what the pipeline evaluates once per scene, `term` for signals and
    `formula` for formulas, with the bindings of their variables. `bounds` are the least and
    greatest number it can be; `items` the parts of lists and points, `keys` those of maps.
    """

    span: Span
    type: Type
    value: Value | None = None
    random: bool = False
    bounds: Bounds = UNKNOWN
    term: Term | None = None
    formula: Formula | None = None
    evidence: DomainEvidence | None = None
    signals: tuple[SignalBinding, ...] = ()
    numbers: tuple[NumberBinding, ...] = ()
    items: tuple[TypedExpression, ...] = ()
    keys: tuple[tuple[str, Span], ...] = ()
    range: bool = False
    """Written `a..b`."""

    @property
    def is_unknown(self) -> bool:
        """Whether an error was reported for this expression already."""
        return isinstance(self.type, Unknown)

    @property
    def constant(self) -> float | None:
        """The number it is in every scene."""
        low, high = self.bounds
        return None if self.random or low != high else low


def unknown(span: Span) -> TypedExpression:
    """The remains of a reported error."""
    return TypedExpression(span, Unknown())
