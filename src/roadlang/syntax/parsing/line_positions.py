"""Where on its line a token stands."""

from __future__ import annotations

from ...diagnostics import Source
from .tokens import Token


def starts_line(source: Source, token: Token) -> bool:
    """Only white space stands before the token on its line."""
    return begins_line(source, token[2])


def begins_line(source: Source, offset: int) -> bool:
    """Only white space stands before this offset on its line. Long lines cost nothing.

    White space is what the grammar skips between tokens: also spaces that do not break (U+00A0).
    """
    text = source.text
    while offset > 0 and text[offset - 1] != "\n" and _is_space(text[offset - 1]):
        offset -= 1
    return offset == 0 or text[offset - 1] == "\n"


def indentation(source: Source, offset: int) -> int:
    """How far the line of this offset is indented."""
    start = source.text.rfind("\n", 0, offset) + 1
    end = start
    while end < offset and source.text[end] in " \t":
        end += 1
    return end - start


def at_margin(source: Source, token: Token) -> bool:
    """Whether the token begins a line with no white space before it."""
    start = token[2]
    return start == 0 or source.text[start - 1] in "\n\ufeff"


def _is_space(character: str) -> bool:
    return character.isspace() or character == "\ufeff"
