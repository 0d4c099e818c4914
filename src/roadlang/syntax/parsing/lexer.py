"""Text to tokens. What cannot be read is reported and replaced by what was probably meant."""

from __future__ import annotations

import re

from ...diagnostics import Source
from ..recovery.suspect_tokens import SUSPECTS
from ..recovery.unprintable import binary, markup, surrogates
from ..tree.nodes import Comment
from .grammar import END
from .line_positions import begins_line
from .tables import Tables
from .tokens import Lexed

_MOST_REPORTED = 50


def lex(source: Source, tables: Tables) -> Lexed:
    """All tokens of a source. Never fails: a bad character is reported and left out."""
    lexed = Lexed()
    found = binary(source) or markup(source)
    if found is not None:
        lexed.diagnostics.append(found)
        lexed.tokens.append((END, "", 0, 0))
        return lexed
    position, length = 0, len(source.text)
    while position < length:
        position = _scan(source, tables, lexed, position)
        if position < length:
            position = _read_unlexable(source, tables, lexed, position)
        if len(lexed.diagnostics) > _MOST_REPORTED:
            # Whatever this is, it is no scene file: what comes behind would tell nothing new.
            lexed.tokens.clear()
            break
    lexed.diagnostics.extend(surrogates(source, lexed.diagnostics))
    del lexed.diagnostics[_MOST_REPORTED:]
    end = source.end.start
    lexed.tokens.append((END, "", end, end))
    return lexed


def _scan(source: Source, tables: Tables, lexed: Lexed, position: int) -> int:
    """Read on from `position`; returns where there is something that is no token."""
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
            if word in letters and re.compile(letters[word]).match(text, start):
                kind = word.upper()
        elif kind in SUSPECTS and SUSPECTS[kind](lexed, text, start, end):
            return start
        elif kind == "COMMENT":
            _comment(source, lexed, start, end)
            continue
        tokens.append((kind, word, start, end))
    return len(text)


def _read_unlexable(source: Source, tables: Tables, lexed: Lexed, start: int) -> int:
    from ..recovery.unlexable import UnlexableText, explain_unlexable

    found, position = explain_unlexable(UnlexableText(source, tables, lexed, start))
    if found is not None:
        lexed.diagnostics.append(found)
    return position


def _comment(source: Source, lexed: Lexed, start: int, end: int) -> None:
    own_line = begins_line(source, start)
    text = source.text[start:end].rstrip()
    lexed.comments.append(Comment(text, own_line, span=source.span(start, start + len(text))))
