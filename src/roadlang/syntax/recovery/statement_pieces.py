"""Cuts a file that does not parse as a whole into pieces that are parsed separately."""

from __future__ import annotations

from collections.abc import Sequence

from ...diagnostics import Source
from ..parsing.grammar import END
from ..parsing.line_positions import at_margin, starts_line
from ..parsing.tokens import Token
from ..words import CLOSERS, OPENERS, STATEMENT_KINDS, STATEMENTS, misspelled
from .error_position import looks_like_item


def pieces(source: Source, tokens: Sequence[Token]) -> list[list[Token]]:
    """One list of tokens for each statement, with an `$END` of its own.

    A piece begins at every word at the left margin. Where brackets are open, it must be a statement
    word, or nearly one, and not look like an item of a block; where none are, such a word will do
    even if it is indented.
    """
    cut: list[list[Token]] = []
    depth = 0
    for index, token in enumerate(tokens[:-1]):
        if not cut or _begins(source, tokens, index, depth):
            cut.append([])
            depth = 0
        cut[-1].append(token)
        if token[0] in OPENERS:
            depth += 1
        elif token[0] in CLOSERS:
            depth = max(0, depth - 1)
    for piece in cut:
        end = piece[-1][3]
        piece.append((END, "", end, end))
    return cut


def _begins(source: Source, tokens: Sequence[Token], index: int, depth: int) -> bool:
    token = tokens[index]
    kind, text = token[0], token[1]
    if not (text[:1].isalpha() or text.startswith("_")):
        return False
    margin = at_margin(source, token)
    if depth == 0 and margin:
        return True
    if not starts_line(source, token) or looks_like_item(tokens, index):
        return False
    if kind in STATEMENT_KINDS:
        return depth == 0 or margin
    named = tokens[index + 1][0] in ("NAME", "STRING")
    return named and (depth == 0 or margin) and misspelled(text, STATEMENTS) is not None
