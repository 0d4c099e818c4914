"""The statements of the syntax tree, and how each is laid out in text."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import ClassVar

from .blocks import Block, KindName
from .expressions import Comment, Expression, String, SyntaxNode, Word


class Statement(SyntaxNode):
    """What begins with a statement word.

    `words` are those that may begin it; where there are several, the field `word` says which.
    `layout` is how it is written: fields in braces. A field that is None is left out, with the word
    before it.
    """

    __slots__ = ()

    words: ClassVar[tuple[str, ...]]
    layout: ClassVar[str]

    @property
    def keyword(self) -> str:
        """The word that begins this statement."""
        return getattr(self, "word", self.words[0])


@dataclass(frozen=True, slots=True)
class Header(Statement):
    """`scenario NAME "title"`."""

    words = ("scenario",)
    layout = "scenario {name} {title}"
    name: Word
    title: String | None


@dataclass(frozen=True, slots=True)
class Include(Statement):
    """`include "file" as NAME { param: value }`."""

    words = ("include",)
    layout = "include {path} as {alias} {block}"
    path: String
    alias: Word | None
    block: Block | None


@dataclass(frozen=True, slots=True)
class Override(Statement):
    """`override NAME { ... }`: other options and passes of what was included."""

    words = ("override",)
    layout = "override {target} {block}"
    target: Expression
    block: Block | None


@dataclass(frozen=True, slots=True)
class Param(Statement):
    """`param NAME = value`."""

    words = ("param",)
    layout = "param {name} = {value}"
    name: Word
    value: Expression


@dataclass(frozen=True, slots=True)
class Let(Statement):
    """`let NAME = value`."""

    words = ("let",)
    layout = "let {name} = {value}"
    name: Word
    value: Expression


@dataclass(frozen=True, slots=True)
class Geometry(Statement):
    """`image | network | road NAME [from SOURCE] { ... }`; `word` is the statement word."""

    words = ("image", "network", "road")
    layout = "{word} {name} from {source} {block}"
    word: str
    name: Word
    source: Expression | None
    block: Block | None


@dataclass(frozen=True, slots=True)
class Constraint(Statement):
    """`require | expect NAME: formula { ... }` or `... NAME with KIND { ... }`."""

    words = ("require", "expect")
    layout = "{word} {name}: {formula} with {kind} {block}"
    word: str
    name: Word
    formula: Expression | None
    kind: KindName | None = None
    block: Block | None = None


@dataclass(frozen=True, slots=True)
class Actor(Statement):
    """`agent | object NAME is KIND [on ROAD] [at PLACE] { ... }`."""

    words = ("agent", "object")
    layout = "{word} {name} is {kind} on {on} at {at} {block}"
    word: str
    name: Word
    kind: Expression
    on: Expression | None
    at: Expression | None
    block: Block | None


@dataclass(frozen=True, slots=True)
class WorldStatement(Statement):
    """`world { ... }`."""

    words = ("world",)
    layout = "world {block}"
    block: Block | None


@dataclass(frozen=True, slots=True)
class RunStep(Statement):
    """`sample | simulate | falsify [with KIND] { ... }`."""

    words = ("sample", "simulate", "falsify")
    layout = "{word} with {kind} {block}"
    word: str
    kind: KindName | None
    block: Block | None


@dataclass(frozen=True, slots=True)
class Emit(Statement):
    """`emit KIND { ... }`."""

    words = ("emit",)
    layout = "emit {kind} {block}"
    kind: KindName
    block: Block | None


STATEMENTS: tuple[type[Statement], ...] = (
    Header, Include, Override, Param, Let, Geometry, Constraint, Actor, WorldStatement, RunStep,
    Emit,
)  # fmt: skip
BY_RULE: dict[str, type[Statement]] = {
    re.sub(r"(?<=[a-z])(?=[A-Z])", "_", node.__name__.removesuffix("Statement")).lower(): node
    for node in STATEMENTS
}
"""The statements by the rule of the grammar that each is named after; `WorldStatement` by `world`,
for a `World` is what the engine drives in."""


@dataclass(frozen=True, slots=True)
class File(SyntaxNode):
    """A whole file. Comments are kept outside the tree, in order of place.

    `spoiled` are the names that statements declare which could not be read (and have been
    reported): nothing should be said about uses of these names.
    """

    statements: tuple[Statement, ...]
    comments: tuple[Comment, ...] = ()
    spoiled: tuple[Word, ...] = field(default=(), compare=False, repr=False)
