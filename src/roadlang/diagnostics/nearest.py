"""Did you mean: the nearest known name."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from difflib import SequenceMatcher, get_close_matches


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known name most like `word`, or None when none is near."""
    candidates = sorted(set(known))
    folded = {name.casefold().replace("-", "_"): name for name in candidates}
    exact = folded.get(word.casefold().replace("-", "_"))
    if exact is not None:
        return exact
    if len(word) < 2:
        return None
    slips = max(1, (len(word) + 1) // 3)
    near = [(edits(word, name, slips), name) for name in candidates]
    fewest = min((count for count, _ in near), default=slips + 1)
    if fewest <= slips:
        return max((name for count, name in near if count == fewest), key=_likeness_to(word))
    alike = get_close_matches(word, candidates, n=1, cutoff=0.7)
    if alike:
        return alike[0]
    starts = [name for name in candidates if name.startswith(word) or word.startswith(name)]
    return starts[0] if len(word) >= 3 and len(starts) == 1 and len(starts[0]) >= 3 else None


def _likeness_to(word: str) -> Callable[[str], float]:
    return lambda name: SequenceMatcher(None, word, name).ratio()


def edits(a: str, b: str, most: int) -> int:
    """How many letters to change, add, drop or swap with a neighbor; above `most`, `most + 1`."""
    if abs(len(a) - len(b)) > most:
        return most + 1
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, x in enumerate(a, start=1):
        before, above, row = row, row if i == 1 else before, [i]
        for j, y in enumerate(b, start=1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                cost = min(cost, above[j - 2] + 1)
            row.append(cost)
        if min(row) > most:
            return most + 1
    return min(row[-1], most + 1)


def did_you_mean(word: str, known: Iterable[str]) -> tuple[str, ...]:
    """A help line naming the nearest known name; empty when none is near."""
    found = nearest(word, known)
    return (f"did you mean `{found}`?",) if found else ()
