"""Which known name an unknown one stands for: its new name, another word for it, or the nearest."""

from __future__ import annotations

from collections.abc import Iterable

from ..diagnostics import nearest
from ..ir.renamed_words import new_name

_SAME_THING = (
    {"broken", "dashed", "dotted"},
    {"road", "street"},
)
"""Words for the same thing: here and in other tools. Kinds say themselves what else
they are called."""


def meant_name(word: str, known: Iterable[str]) -> str | None:
    """The known name that `word` is now called, that means the same, that it is inside an included
    file, or that is the most similar one; None if none is similar."""
    names = tuple(known)
    return (
        new_name(word, names)
        or _same_thing(word, names)
        or nearest(word, names)
        or _name_in_a_file(word, names)
    )


def _same_thing(word: str, known: tuple[str, ...]) -> str | None:
    """The known word of the same meaning; a word that is known itself has none."""
    others = [same for same in _SAME_THING if word.casefold() in same]
    found = [name for same in others for name in known if name in same]
    return found[0] if found and word not in known else None


def _name_in_a_file(word: str, known: tuple[str, ...]) -> str | None:
    """The only known name of this word that is in an included file: `left.street`."""
    found = [name for name in known if name.endswith(f".{word}")]
    return found[0] if len(found) == 1 else None


def suggestion(word: str, meant: str) -> str:
    """The help line that suggests `meant` in the place of `word`."""
    if new_name(word, (meant,)):
        return f"it is now called `{meant}`"
    return f"did you mean `{meant}`?"
