"""Which known name an unknown one stands for: its new name, another word for it, or the nearest."""

from __future__ import annotations

from collections.abc import Iterable

from ..diagnostics import nearest
from ..ir.renamed_words import new_name

_SAME_THING = (
    {"broken", "dashed", "dotted"},
    {"road", "street"},
)
"""Words that mean the same, here or in other tools. Other names of kinds are theirs to state
(`also_called`)."""


def meant_name(word: str, known: Iterable[str]) -> str | None:
    """The known name that `word` has been renamed to, that means the same, that is most similar, or
    that it has in an included file; None for none of these."""
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
    """The name of this word in an included file (`left.street`), if there is only one."""
    found = [name for name in known if name.endswith(f".{word}")]
    return found[0] if len(found) == 1 else None


def suggestion(word: str, meant: str) -> str:
    """The help line that suggests `meant` in the place of `word`."""
    if new_name(word, (meant,)):
        return f"it is now called `{meant}`"
    return f"did you mean `{meant}`?"
