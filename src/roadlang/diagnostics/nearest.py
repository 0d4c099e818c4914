"""Did you mean: the nearest known name."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known name most like `word`, or None when none is near."""
    candidates = sorted(set(known))
    folded = {name.casefold().replace("-", "_"): name for name in candidates}
    exact = folded.get(word.casefold().replace("-", "_"))
    if exact is not None:
        return exact
    found = get_close_matches(word, candidates, n=1, cutoff=0.6)
    if not found and len(word) >= 3:
        starts = [name for name in candidates if name.startswith(word) or word.startswith(name)]
        return min(starts, key=len) if len(starts) == 1 else None
    return found[0] if found else None


def did_you_mean(word: str, known: Iterable[str]) -> tuple[str, ...]:
    """A help line naming the nearest known name; empty when none is near."""
    found = nearest(word, known)
    return (f"did you mean `{found}`?",) if found else ()
