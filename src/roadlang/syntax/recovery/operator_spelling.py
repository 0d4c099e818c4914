"""`alwyas (p)` reads as a call. The temporal words are looked for before that happens."""

from __future__ import annotations

from collections.abc import Sequence

from ..operators import words
from ..parsing.tokens import Token
from ..words import slip

_LONG = tuple(word for word in words("temporal") if len(word) > 4)
"""A short one is a slip of many a name."""

_FOREIGN = {"globally": "always", "finally": "eventually", "sometime": "eventually"}


def misspelled_temporal(tokens: Sequence[Token], start: int = 0) -> int | None:
    """The index of the first name before `(` or `[` that is a long temporal word with a slip."""
    for index in range(start, len(tokens) - 1):
        before_bracket = tokens[index + 1][0] in ("LPAR", "LSQB") and tokens[index][0] == "NAME"
        if before_bracket and meant_temporal(tokens[index][1]) is not None:
            return index
    return None


def meant_temporal(word: str) -> str | None:
    """The temporal operator that `word` misspells, if it does."""
    if word in _FOREIGN:
        return _FOREIGN[word]
    if not 5 <= len(word) <= 14:
        return None
    return next((known for known in _LONG if slip(word, known)), None)
