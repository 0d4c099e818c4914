"""Text to tokens. What cannot be read is reported and replaced by what was probably meant."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

from ..diagnostics import Diagnostic, Source
from .ast import Comment
from .tables import END, Tables

Token: TypeAlias = tuple[str, str, int, int]
"""kind, text, start, end"""


@dataclass(slots=True)
class Lexed:
    """The tokens of a source, the last one `$END`; comments stand beside them."""

    tokens: list[Token] = field(default_factory=list)
    comments: list[Comment] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)


def lex(source: Source, tables: Tables) -> Lexed:
    """All tokens of a source. Never fails: a bad character is reported and left out."""
    lexed = Lexed()
    position, length = 0, len(source.text)
    while position < length:
        position = _scan(source, tables, lexed, position)
    end = source.end.start
    lexed.tokens.append((END, "", end, end))
    return lexed


def _scan(source: Source, tables: Tables, lexed: Lexed, position: int) -> int:
    """Read on from `position` up to the first thing that is no token; returns where to go on."""
    text, keywords, letters = source.text, tables.keywords, tables.letters
    tokens = lexed.tokens
    for match in tables.scanner.finditer(text, position):
        kind = match.lastgroup
        if kind is None:
            break
        start, end = match.span(kind)
        word = text[start:end]
        if kind == "NAME":
            kind = keywords.get(word, kind)
            if word in letters and letters[word].match(text, start):
                kind = word
        elif kind == "COMMENT":
            _comment(source, lexed, start, end)
            continue
        elif kind == "BAD":
            return end
        tokens.append((kind, word, start, end))
    return len(text)


def _comment(source: Source, lexed: Lexed, start: int, end: int) -> None:
    line = source.text.rfind("\n", 0, start) + 1
    own_line = not source.text[line:start].strip("\ufeff \t\r\f\v")
    text = source.text[start:end].rstrip()
    lexed.comments.append(Comment(text, own_line, span=source.span(start, start + len(text))))
