"""The place where the parser is stuck, and the questions that explanations ask of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...diagnostics import Diagnostic, Source, Span
from ..parsing.engine import accepts, advance, expected
from ..parsing.grammar import END
from ..parsing.line_positions import starts_line
from ..parsing.tables import Tables
from ..parsing.tokens import Token
from ..words import CLOSERS, OPENERS, STATEMENT_KINDS


@dataclass(frozen=True, slots=True)
class Edit:
    """Tokens `start` to `end` (exclusive) of a piece are replaced, so that parsing can go on."""

    start: int
    end: int
    tokens: tuple[Token, ...] = ()


@dataclass(frozen=True, slots=True)
class Mistake:
    """What to tell the user, and how to go on. Without an edit what is around is left out.

    `culprit` is the token whose item is left out; a hopeless mistake spoils its whole statement.
    """

    diagnostic: Diagnostic | None
    edit: Edit | None = None
    culprit: int | None = None
    hopeless: bool = False


@dataclass(frozen=True, slots=True)
class ErrorPosition:
    """The tokens of a piece, the one that does not fit, and the parser's stack before it."""

    source: Source
    tables: Tables
    start: str
    tokens: Sequence[Token]
    index: int
    states: tuple[int, ...] = ()

    def token(self, offset: int = 0) -> Token:
        """The token this many places later; before the first and after the last: `$END`."""
        index = self.index + offset
        if 0 <= index < len(self.tokens):
            return self.tokens[index]
        return (END, "", 0, 0) if index < 0 else self.tokens[-1]

    def kind(self, offset: int = 0) -> str:
        """Terminal of the token `offset` after the error."""
        return self.token(offset)[0]

    def word(self, offset: int = 0) -> str:
        """Text of the token `offset` after the error."""
        return self.token(offset)[1]

    def span(self, first: int = 0, last: int | None = None) -> Span:
        """From the token at offset `first` to the end of that at `last`."""
        end = self.token(first if last is None else last)[3]
        return self.source.span(self.token(first)[2], end)

    def glued(self, offset: int) -> bool:
        """Nothing stands between the token at this offset and the one before it."""
        return self.token(offset - 1)[3] == self.token(offset)[2]

    def starts_line(self, offset: int = 0) -> bool:
        """Whether only white space precedes the token on its line."""
        return starts_line(self.source, self.token(offset))

    def expects(self, *kinds: str) -> bool:
        """Whether these terminals, one after the other, would be accepted here."""
        return accepts(self.tables, self.states, *kinds)

    def expected(self) -> set[str]:
        """Every terminal that would be accepted here."""
        return expected(self.tables, self.states)

    @property
    def wants_value(self) -> bool:
        """Whether a value would be accepted here."""
        return self.expects("NUMBER")

    @property
    def in_block(self) -> bool:
        """Whether the innermost bracket open here is a brace."""
        depth = 0
        for kind, *_ in reversed(self.tokens[: self.index]):
            if kind in CLOSERS:
                depth += 1
            elif kind in OPENERS and depth == 0:
                return kind == "LBRACE"
            elif kind in OPENERS:
                depth -= 1
        return False

    @property
    def first_kind(self) -> str:
        """Terminal of the first token of the file."""
        return self.tokens[0][0]

    def back(self, offset: int) -> ErrorPosition | None:
        """The same piece, looked at from the token at a negative offset."""
        index = self.index + offset
        if index < 0:
            return None
        stack = [self.tables.starts[self.start]]
        for token in self.tokens[:index]:
            if not advance(self.tables, stack, token[0]):
                return None
        return ErrorPosition(self.source, self.tables, self.start, self.tokens, index, tuple(stack))

    def continues(self, *kinds: str, skip: int = 0, over: int = 3) -> bool:
        """Whether, with these kinds put in here, the next few tokens fit."""
        first = self.index + skip
        following = [token[0] for token in self.tokens[first : first + over]]
        return accepts(self.tables, self.states, *kinds, *following)

    def unmatched_closer(self) -> str | None:
        """The kind of the first closing bracket after this place that nothing here opens."""
        stack: list[str] = []
        for index, (kind, *_) in enumerate(self.tokens):
            if kind in OPENERS:
                stack.append(kind)
            elif kind in CLOSERS:
                if stack and stack[-1] == CLOSERS[kind]:
                    stack.pop()
                elif index >= self.index:
                    return kind
        return None


def looks_like_item(tokens: Sequence[Token], index: int) -> bool:
    """`key:` or `verb with`: an item of a block, not a statement (`sample with` is one)."""
    kind, text, *_ = tokens[index]
    if not text[:1].isalpha() and not text.startswith("_"):
        return False
    following = tokens[index + 1][0] if index + 1 < len(tokens) else END
    return following == "COLON" or (following == "WITH" and kind not in STATEMENT_KINDS)
