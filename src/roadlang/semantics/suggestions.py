"""Which known name an unknown one stands for: its new name, or the nearest."""

from __future__ import annotations

from collections.abc import Iterable

from ..diagnostics import nearest
from ..ir.renamed_words import new_name


def meant_name(word: str, known: Iterable[str]) -> str | None:
    """The known name that `word` is now called, or the most similar one; None if none is
    similar."""
    names = tuple(known)
    return new_name(word, names) or nearest(word, names)


def suggestion(word: str, meant: str) -> str:
    """The help line that suggests `meant` in the place of `word`."""
    if new_name(word, (meant,)):
        return f"it is now called `{meant}`"
    return f"did you mean `{meant}`?"
