"""Blocks of the syntax tree: options and passes between braces."""

from __future__ import annotations

from dataclasses import dataclass, field

from .expressions import Expression, SyntaxNode, Word


@dataclass(frozen=True, slots=True)
class KindName(SyntaxNode):
    """The name of a kind, `sine` or `acme.sine`: `text` is the dotted whole."""

    text: str


@dataclass(frozen=True, slots=True)
class Option(SyntaxNode):
    """`key: value` in a block."""

    key: Word
    value: Expression


@dataclass(frozen=True, slots=True)
class Pass(SyntaxNode):
    """`verb with kind as label { ... }`."""

    verb: Word
    kind: KindName
    label: Word | None
    block: Block | None


@dataclass(frozen=True, slots=True)
class Block(SyntaxNode):
    """Options and passes in the order written.

    `complete` is False when an item could not be read (and has been reported): an option that
    seems to be missing may be that one.
    """

    items: tuple[Option | Pass, ...]
    complete: bool = field(default=True, compare=False, repr=False, kw_only=True)

    @property
    def options(self) -> tuple[Option, ...]:
        """The options of the block, in order."""
        return tuple(item for item in self.items if isinstance(item, Option))

    @property
    def passes(self) -> tuple[Pass, ...]:
        """The passes of the block, in order."""
        return tuple(item for item in self.items if isinstance(item, Pass))
