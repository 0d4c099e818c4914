"""Words and expressions of the syntax tree: what was written, where. Nothing is resolved.

Equality ignores spans, so that `parse(format(tree)) == tree` can be asserted.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

from ...diagnostics import Span


@dataclass(frozen=True, slots=True)
class SyntaxNode:
    """Anything written at one place."""

    span: Span = field(compare=False, repr=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class Word(SyntaxNode):
    """A name where it is declared, an option key, a verb, a member."""

    text: str


@dataclass(frozen=True, slots=True)
class Comment(SyntaxNode):
    """`# text`, with the mark. `own_line`: nothing else stands on its line."""

    text: str
    own_line: bool


# --- expressions -------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class NumberLiteral(SyntaxNode):
    """`8`, `0.35m/px`, `95%`: the digits as written and the unit text glued to them."""

    digits: str
    unit: str = ""

    @property
    def value(self) -> float:
        """The number that the digits mean."""
        return float(self.digits)


@dataclass(frozen=True, slots=True)
class String(SyntaxNode):
    """`"text"`, escapes resolved."""

    value: str


@dataclass(frozen=True, slots=True)
class Text(SyntaxNode):
    """A triple-quoted text, dedented."""

    value: str


@dataclass(frozen=True, slots=True)
class Boolean(SyntaxNode):
    """`true` or `false`."""

    value: bool


@dataclass(frozen=True, slots=True)
class Name(SyntaxNode):
    """A reference to what the checker knows; one that is `quoted` names the column of a trace.

    `short` is the name as the file has it, where the file is included under a name of its own.
    """

    text: str
    quoted: bool = False
    short: str | None = None

    @property
    def word(self) -> str:
        """The name as the file has it: kinds and words of options have no other."""
        return self.text if self.short is None else self.short


@dataclass(frozen=True, slots=True)
class Member(SyntaxNode):
    """`ego.speed`."""

    of: Expression
    name: Word


@dataclass(frozen=True, slots=True)
class Numbered(SyntaxNode):
    """`cars[0]`: one of the copies of a group."""

    of: Expression
    number: NumberLiteral


@dataclass(frozen=True, slots=True)
class Argument(SyntaxNode):
    """An argument of a call, `x` or `key: x`."""

    value: Expression
    key: Word | None = None


@dataclass(frozen=True, slots=True)
class CallExpression(SyntaxNode):
    """`f(x, key: y)`; `function` is a name or a dotted name."""

    function: Name | Member
    arguments: tuple[Argument, ...]


@dataclass(frozen=True, slots=True)
class NegateExpression(SyntaxNode):
    """`-operand`."""

    operand: Expression


@dataclass(frozen=True, slots=True)
class ArithmeticExpression(SyntaxNode):
    """`operator` is one of `+ - * / ^`."""

    operator: str
    left: Expression
    right: Expression
    operator_span: Span = field(compare=False, repr=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class Draw(SyntaxNode):
    """`low..high`: a uniform draw."""

    low: Expression
    high: Expression


@dataclass(frozen=True, slots=True)
class ComparisonExpression(SyntaxNode):
    """`a < b` or a chain `a < b < c`: one more operand than operators (`< <= > >= == !=`)."""

    operands: tuple[Expression, ...]
    operators: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class NotExpression(SyntaxNode):
    """`not operand`."""

    operand: Expression


@dataclass(frozen=True, slots=True)
class IntervalExpression(SyntaxNode):
    """`[low, high]` after a temporal word."""

    low: Expression
    high: Expression


@dataclass(frozen=True, slots=True)
class Temporal(SyntaxNode):
    """`always`, `next` and their kin; `word` is canonical, as habits are read."""

    word: str
    interval: IntervalExpression | None
    operand: Expression
    word_span: Span = field(compare=False, repr=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class MeasureExpression(SyntaxNode):
    """`count[a, b] (p)` and `duration[a, b] (p)`: numbers, to be compared with a number."""

    word: str
    interval: IntervalExpression | None
    operand: GroupExpression
    word_span: Span = field(compare=False, repr=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class Binding(SyntaxNode):
    """`left until[a, b] right` and its kin; `word` is canonical."""

    word: str
    interval: IntervalExpression | None
    left: Expression
    right: Expression
    word_span: Span = field(compare=False, repr=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class Logic(SyntaxNode):
    """`and`, `or` (two or more operands), `implies`, `iff`, `xor` (two operands)."""

    word: str
    operands: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class GroupExpression(SyntaxNode):
    """`(x)`: kept, since the parentheses rule and `fmt` need it."""

    inner: Expression


@dataclass(frozen=True, slots=True)
class Point(SyntaxNode):
    """`(x, y)`."""

    items: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class ListValue(SyntaxNode):
    """`[a, b, c]`: a list or an interval; never a draw."""

    items: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class MapEntry(SyntaxNode):
    """`key: value` in a map."""

    key: Word | String
    value: Expression


@dataclass(frozen=True, slots=True)
class MapValue(SyntaxNode):
    """`{ key: value, ... }` as a value."""

    entries: tuple[MapEntry, ...]


Expression: TypeAlias = (
    NumberLiteral
    | String
    | Text
    | Boolean
    | Name
    | Member
    | Numbered
    | CallExpression
    | NegateExpression
    | ArithmeticExpression
    | Draw
    | ComparisonExpression
    | NotExpression
    | Temporal
    | MeasureExpression
    | Binding
    | Logic
    | GroupExpression
    | Point
    | ListValue
    | MapValue
)
