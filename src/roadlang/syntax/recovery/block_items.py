"""The items of the blocks of a piece, as far as brackets, commas and lines tell them."""

from __future__ import annotations

from collections.abc import Sequence

from ...diagnostics import Source
from ..parsing.line_positions import starts_line
from ..parsing.tokens import Token
from ..words import CLOSERS, OPENERS
from .error_position import looks_like_item

UNREADABLE = "UNREADABLE"


def spoil(source: Source, tokens: Sequence[Token], culprit: int) -> list[Token] | None:
    """The tokens with the item around one of them marked as unreadable.

    None when the token stands in no block (or the item has been marked before).
    """
    block = _block_around(tokens, culprit)
    if block is None:
        return None
    opener, closer = block
    for start, end in _items(source, tokens, opener, closer):
        ends_item = culprit == end and (end == closer or tokens[end][0] == "COMMA")
        if start <= culprit < end or ends_item:
            if all(token[0] == UNREADABLE for token in tokens[start:end]):
                break
            mark: Token = (UNREADABLE, "", tokens[start][2], tokens[end - 1][3])
            return [*tokens[:start], mark, *tokens[end:]]
    return spoil(source, tokens, opener)


def _block_around(tokens: Sequence[Token], culprit: int) -> tuple[int, int] | None:
    """The brace of the innermost block (not map) that holds a token, and that which ends it."""
    stack: list[int] = []
    for index in range(culprit):
        kind = tokens[index][0]
        if kind in OPENERS:
            stack.append(index)
        elif kind in CLOSERS and stack:
            stack.pop()
    blocks = [
        index
        for index in stack
        if tokens[index][0] == "LBRACE" and (index == 0 or tokens[index - 1][0] != "COLON")
    ]
    if not blocks:
        return None
    depth = 0
    for index in range(blocks[-1], len(tokens)):
        depth += (tokens[index][0] in OPENERS) - (tokens[index][0] in CLOSERS)
        if depth == 0:
            return blocks[-1], index
    return blocks[-1], len(tokens) - 1


def _items(
    source: Source, tokens: Sequence[Token], opener: int, closer: int
) -> list[tuple[int, int]]:
    """Ranges of tokens between commas, before lines that begin an item, and after `}`."""
    found: list[tuple[int, int]] = []
    depth, start = 0, opener + 1
    for index in range(opener + 1, closer):
        token = tokens[index]
        before = tokens[index - 1]
        new_line = starts_line(source, token) and looks_like_item(tokens, index)
        new_pass = before[0] == "RBRACE" and looks_like_item(tokens, index)
        if depth == 0 and index > start and (new_line or new_pass):
            found.append((start, index))
            start = index
        if depth == 0 and token[0] == "COMMA":
            found.append((start, index))
            start = index + 1
        depth += (token[0] in OPENERS) - (token[0] in CLOSERS)
    found.append((start, closer))
    return [(first, last) for first, last in found if first < last]
