"""Reads what can be read of a file that does not parse as a whole, and says why."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from ...diagnostics import Code, Diagnostic, Fix, Source, diagnose
from ..parsing.engine import Build, ParseError, run
from ..parsing.tables import Tables
from ..parsing.tokens import Lexed, Token
from ..tree import nodes as ast
from ..words import RESERVED_KINDS, STATEMENT_KINDS, STATEMENTS, misspelled
from .block_items import UNREADABLE, spoil
from .brackets import close_brackets, too_deep
from .error_position import ErrorPosition, Mistake, looks_like_item
from .known_mistakes import explain
from .operator_spelling import meant_temporal, misspelled_temporal
from .statement_habits import as_include, statement_help
from .statement_pieces import pieces

_MOST_PER_PIECE = 20
_MOST_TOKENS = 400_000


@dataclass(slots=True)
class Recovery:
    """The state of one recovery: what is known to be wrong, and how much may still be tried."""

    source: Source
    tables: Tables
    builds: list[Build]
    reported_lines: frozenset[int]
    """Lines with an unreadable character: a complaint of the parser there would be an echo."""
    diagnostics: list[Diagnostic] = field(default_factory=list)
    spoiled: list[ast.Word] = field(default_factory=list)
    first_guess: int | None = None
    """From here on a bracket has been closed by guess: complaints would be about the guess."""
    budget: int = _MOST_TOKENS

    def file(self, lexed: Lexed) -> list[ast.Statement]:
        """The statements of all pieces that can be read."""
        statements: list[ast.Statement] = []
        for piece in pieces(self.source, lexed.tokens):
            value = self.piece("file", self.first_word(piece))
            if value is not None:
                statements.extend(value.statements)
        return statements

    def piece(self, start: str, tokens: list[Token]) -> Any:
        """The value of one piece, or None if nothing can be made of it."""
        original = tokens
        tokens = self.correct_spelling(tokens)
        deep = too_deep(tokens)
        if deep is not None:
            span = self.source.span(tokens[deep][2], tokens[deep][3])
            self.diagnostics.append(diagnose(Code.NESTING_TOO_DEEP, span))
            return self.give_up(original)
        value = self.attempt(start, tokens)
        if not isinstance(value, ParseError):
            return value
        tokens, unclosed = close_brackets(self.source, tokens)
        self.diagnostics.extend(unclosed)
        self.first_guess = _first_guess(unclosed)
        for _ in range(_MOST_PER_PIECE):
            value = self.attempt(start, tokens)
            if not isinstance(value, ParseError):
                return value if tokens[0][0] != UNREADABLE else self.give_up(original)
            repaired = self.repair(start, tokens, value)
            if repaired is None or self.budget < 0:
                break
            tokens = repaired
        return self.give_up(original)

    def correct_spelling(self, tokens: list[Token]) -> list[Token]:
        """Misspelled temporal words that would be read as calls, put right."""
        repaired = list(tokens)
        index = misspelled_temporal(repaired)
        while index is not None:
            _, text, start, end = repaired[index]
            meant = meant_temporal(text) or text
            span = self.source.span(start, end)
            help, fixes = f"did you mean `{meant}`?", (Fix(span, meant),)
            self.diagnostics.append(
                diagnose(Code.MISSPELLED_WORD, span, word=text, help=help, fixes=fixes)
            )
            repaired[index] = (meant.upper(), meant, start, end)
            index = misspelled_temporal(repaired, index)
        return repaired

    def attempt(self, start: str, tokens: list[Token]) -> Any:
        """Parse `tokens` from the start symbol `start`. Raises where they do not fit."""
        self.budget -= len(tokens)
        return run(self.tables, start, tokens, self.builds)

    def repair(self, start: str, tokens: list[Token], error: ParseError) -> list[Token] | None:
        """Report what is wrong, and return tokens with which reading can go on."""
        error_at = ErrorPosition(self.source, self.tables, start, tokens, error.index)
        place = error_at.back(0)
        assert place is not None, "the parser has come this far"
        mistake = explain(place)
        self.report(mistake)
        if mistake.hopeless:
            return None
        edit = mistake.edit
        if edit is not None:
            return [*tokens[: edit.start], *edit.tokens, *tokens[edit.end :]]
        culprit = error.index if mistake.culprit is None else mistake.culprit
        return spoil(self.source, tokens, culprit)

    def report(self, mistake: Mistake) -> None:
        """Keep the diagnostic of a mistake, unless its line or an earlier guess has it already."""
        found = mistake.diagnostic
        if found is None or found.span is None or found.span.line in self.reported_lines:
            return
        if self.first_guess is None or found.span.start < self.first_guess:
            self.diagnostics.append(found)

    def give_up(self, tokens: list[Token]) -> None:
        """A statement that cannot be read: remember the name that it declares."""
        if len(tokens) < 2:
            return
        # `e1 = 3m` lacks its first word.
        declared = tokens[0] if tokens[1][0] == "EQUAL" else tokens[1]
        if declared[0] == "NAME":
            _, text, start, end = declared
            self.spoiled.append(ast.Word(text, span=self.source.span(start, end)))

    def first_word(self, tokens: list[Token]) -> list[Token]:
        """A piece must begin with a statement word; a misspelled one is put right."""
        kind, text, start, end = tokens[0]
        if kind in STATEMENT_KINDS or (kind not in RESERVED_KINDS and not text[:1].isalpha()):
            return tokens
        meant = misspelled(text, STATEMENTS)
        span = self.source.span(start, end)
        habit = statement_help(tokens)
        if habit:
            meant = None
        help = [f"did you mean `{meant}`?"] if meant is not None else list(habit)
        if not help and looks_like_item(tokens, 0):
            help = ["options and passes are written inside the braces of a statement"]
        fixes = [Fix(span, meant)] if meant is not None else []
        include = as_include(self.source, tokens)
        if include is not None:
            fixes = [include[0]]
        self.diagnostics.append(
            diagnose(Code.UNKNOWN_STATEMENT, span, word=text, help=help, fixes=fixes)
        )
        if include is not None:
            return include[1]
        if meant is None:
            self.give_up(tokens)
            return [tokens[-1]]
        return [(meant.upper(), meant, start, end), *tokens[1:]]


def _first_guess(unclosed: list[Diagnostic]) -> int | None:
    """Where the first `(` or `[` stands of which the end is not known."""
    spans = [found.span for found in unclosed if found.span is not None]
    return min((span.start for span in spans if span.text in ("(", "[")), default=None)
