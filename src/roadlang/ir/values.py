"""Values of the abstract scenario: constants, draws, references and what is computed of them.

All quantities are in SI units and radians. A value is a tree; the pipeline evaluates it for a
batch of variants at a time.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

from ..diagnostics import Span
from ..stl import Formula
from ..stl.formula.evaluation_options import PLAIN, EvaluationOptions
from .dimension import PURE, Dimension
from .read_only import FrozenDict
from .schema import UNWRITTEN

NO_OPTIONS: Options = FrozenDict()
NO_SPANS: FrozenDict[str, Span] = FrozenDict()


@dataclass(frozen=True, slots=True)
class ConstantValue:
    """A number in SI units."""

    value: float
    dimension: Dimension = PURE


@dataclass(frozen=True, slots=True)
class Flag:
    """`true` or `false`."""

    value: bool


@dataclass(frozen=True, slots=True)
class TextValue:
    """A string, or a word of an option that takes words (`auto` is `Text("auto")`)."""

    value: str


@dataclass(frozen=True, slots=True)
class Reference:
    """A `param` or `let`: one draw per scene, however often it is used."""

    name: str


@dataclass(frozen=True, slots=True)
class RandomValue:
    """A random value; `place` keys the draw: `bent/perturb 1/amplitude`.

    `per`: made anew for each "road" of a network or each "copy" of a `count`, else per "scene".
    """

    place: str
    call: PassCall
    per: str = "scene"
    dimension: Dimension = PURE


@dataclass(frozen=True, slots=True)
class Operation:
    """`operator`: `+ - * / ^ negate abs min max`."""

    operator: str
    operands: tuple[Value, ...]


@dataclass(frozen=True, slots=True)
class Measure:
    """A number that the scene's geometry has: `length(street)`, `lead.start`."""

    call: PassCall


@dataclass(frozen=True, slots=True)
class Entity:
    """An image, network, road, agent or object, by name. `copy`: the number
    of a copy of a group, from 1; 0 for the whole group."""

    name: str
    role: str
    copy: int = 0

    @property
    def text(self) -> str:
        """The name as it is written: `cars`, or `cars[0]` for the first of a group."""
        return f"{self.name}[{self.copy - 1}]" if self.copy else self.name


@dataclass(frozen=True, slots=True)
class Items:
    """A list, an interval or a point: the option's type tells which."""

    items: tuple[Value, ...]


@dataclass(frozen=True, slots=True)
class Entries:
    """A map."""

    entries: Options


@dataclass(frozen=True, slots=True)
class SignalBinding:
    """The variable of a formula that stands for a signal."""

    variable: str
    call: PassCall
    dimension: Dimension


@dataclass(frozen=True, slots=True)
class NumberBinding:
    """The variable of a formula that stands for a number of the scene."""

    variable: str
    value: Value


@dataclass(frozen=True, slots=True)
class Condition:
    """A formula with what its variables stand for.

    `domain` is "road" (over arc length), "drive" (over time) or "scene" (numbers alone).
    `text` is the formula as written, in canonical form, with its options in braces.
    """

    text: str
    formula: Formula
    domain: str
    signals: tuple[SignalBinding, ...] = ()
    numbers: tuple[NumberBinding, ...] = ()
    evaluation: EvaluationOptions = PLAIN
    semantics_span: Span | None = field(
        default=None, compare=False, metadata=UNWRITTEN
    )  # where the value of `semantics` is written, for diagnostics


@dataclass(frozen=True, slots=True)
class PassCall:
    """A kind with the options given in the source; options not given take their defaults.

    `kind` is the qualified name in the registry (`roadlang.sine`); `place` names the call for
    people and keys its draws (`bent/perturb 1`). `common` holds the options that every kind of
    the verb has (`over`, `taper`, `roads`, `when`).
    """

    verb: str
    kind: str
    options: Options
    place: str
    span: Span | None = None
    common: Options = NO_OPTIONS
    option_spans: FrozenDict[str, Span] = field(
        default=NO_SPANS, compare=False, metadata=UNWRITTEN
    )  # where the values are written, for diagnostics

    def option(self, name: str) -> Value | None:
        """The value given for an option, or None."""
        return self.options.get(name) or self.common.get(name)


Value: TypeAlias = (
    ConstantValue
    | Flag
    | TextValue
    | Reference
    | RandomValue
    | Operation
    | Measure
    | Entity
    | Items
    | Entries
    | Condition
    | PassCall
)

Options: TypeAlias = FrozenDict[str, Value]
"""What is written, by name, in the order of the fields of the kind or statement."""
