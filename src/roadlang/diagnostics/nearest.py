"""Did you mean: the nearest known name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from functools import cached_property, lru_cache
from heapq import nsmallest
from itertools import takewhile

MANY = 64
"""Up to so many known names a word is compared with each of them, letter by letter."""

CHOSEN = 16
"""Of more names it is compared with those that share the most trigrams with it."""

_MOST_POSTINGS = 2048
"""So many names are counted for a word."""


def nearest(word: str, known: Iterable[str] | KnownNames) -> str | None:
    """The known name most similar to `word`, or None if none is similar."""
    if isinstance(known, KnownNames):
        return _nearest(word, known)
    return _nearest_of(word, tuple(known))


@lru_cache(maxsize=256)
def _nearest_of(word: str, known: tuple[str, ...]) -> str | None:
    return _nearest(word, _known(known))


def _nearest(word: str, names: KnownNames) -> str | None:
    exact = names.by_folded.get(_folded(word))
    if exact is not None:
        return exact
    if len(word) < 2:
        return None
    candidates = names.like(word)
    return _fewest_edits(word, candidates) or _most_similar(word, candidates)


def did_you_mean(word: str, known: Iterable[str]) -> tuple[str, ...]:
    """A help line that names the most similar known name; empty if none is similar."""
    found = nearest(word, known)
    return (f"did you mean `{found}`?",) if found else ()


class KnownNames:
    """The names that a word is compared with, indexed: for many words and many names."""

    def __init__(self, names: Iterable[str]) -> None:
        self.names = tuple(names)
        self.sorted = sorted(set(self.names))
        self.by_folded = {_folded(name): name for name in self.sorted}

    @cached_property
    def by_trigram(self) -> dict[str, list[str]]:
        """The names that have each trigram."""
        found: dict[str, list[str]] = {}
        for name in self.sorted:
            for trigram in _trigrams(name):
                found.setdefault(trigram, []).append(name)
        return found

    def like(self, word: str) -> list[str]:
        """The names worth comparing with `word`, all if they are few; the most promising first."""
        if len(self.sorted) <= MANY:
            return self.sorted
        lists = [self.by_trigram.get(trigram, []) for trigram in _trigrams(word)]
        shared: Counter[str] = Counter()
        looked_at = 0
        for names in sorted(filter(None, lists), key=len):  # what few names have says most
            if shared and looked_at + len(names) > _MOST_POSTINGS:
                break
            looked_at += len(names)
            shared.update(names[:_MOST_POSTINGS])
        # By count, then by name, so that the choice is the same in every process.
        chosen = nsmallest(CHOSEN, ((-count, name) for name, count in shared.items()))
        return [name for _, name in chosen]


@lru_cache(maxsize=16)
def _known(names: tuple[str, ...]) -> KnownNames:
    return KnownNames(names)


def _folded(name: str) -> str:
    return name.casefold().replace("-", "_")


def _trigrams(name: str) -> set[str]:
    padded = f"  {name.casefold()} "
    return {padded[start : start + 3] for start in range(len(padded) - 2)}


def _fewest_edits(word: str, candidates: list[str]) -> str | None:
    """The name that takes the fewest edits, at most one for every three letters."""
    fewest = max(1, (len(word) + 1) // 3)
    best: list[str] = []
    for name in candidates:
        count = edits(word, name, fewest)
        if count < fewest:
            fewest, best = count, [name]
        elif count == fewest:
            best.append(name)
    return max(sorted(best), key=_likeness_to(word)) if best else None


def _most_similar(word: str, candidates: list[str]) -> str | None:
    """A name of which the word is a rough copy or the only beginning."""
    candidates = sorted(candidates)
    from difflib import get_close_matches  # only for those who misspell

    similar = get_close_matches(word, candidates, n=1, cutoff=0.7)
    if similar:
        return similar[0]
    starts = [name for name in candidates if name.startswith(word) or word.startswith(name)]
    if len(word) >= 3 and len(starts) == 1 and len(starts[0]) >= 3:
        return starts[0]
    return _same_stem(word, candidates)


def _same_stem(word: str, candidates: list[str]) -> str | None:
    """The only name that starts as the word does and has another ending: `bended`, `bent`."""
    found = []
    for name in candidates:
        shared = _shared_start(word, name)
        most, least = max(len(word), len(name)), min(len(word), len(name))
        if shared >= 3 and least > 3 and most - least <= 2 and most - shared <= 3:
            found.append(name)
    return found[0] if len(found) == 1 else None


def _likeness_to(word: str) -> Callable[[str], tuple[float, int]]:
    """How alike a name is, and how many first letters they share: `tre` is `tree`, not `tire`."""
    from difflib import SequenceMatcher

    return lambda name: (SequenceMatcher(None, word, name).ratio(), _shared_start(word, name))


def _shared_start(a: str, b: str) -> int:
    """How many first letters two words share."""
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(a, b, strict=False)))


def edits(a: str, b: str, most: int) -> int:
    """How many letters to change, add, drop or swap with a neighbor; above `most`, `most + 1`.

    The restricted Damerau-Levenshtein distance, computed in a band of `most` cells beside the
    diagonal (Ukkonen 1985).
    """
    if abs(len(a) - len(b)) > most:
        return most + 1
    a, b = _without_common_ends(a, b)
    far = most + 1
    before: list[int] = []
    row = [min(j, far) for j in range(len(b) + 1)]
    for i, x in enumerate(a, start=1):
        above, before = before, row
        row = [far] * (len(b) + 1)
        if i <= most:
            row[0] = i
        for j in range(max(1, i - most), min(len(b), i + most) + 1):
            y = b[j - 1]
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                cost = min(cost, above[j - 2] + 1)
            row[j] = cost
        if min(row) > most:
            return far
    return min(row[-1], far)


def _without_common_ends(a: str, b: str) -> tuple[str, str]:
    shorter = min(len(a), len(b))
    first = 0
    while first < shorter and a[first] == b[first]:
        first += 1
    last = 0
    while last < shorter - first and a[-1 - last] == b[-1 - last]:
        last += 1
    return a[first : len(a) - last], b[first : len(b) - last]
