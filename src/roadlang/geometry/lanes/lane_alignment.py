"""Lists of lanes laid side by side, so that those of the same kind meet."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from functools import reduce
from typing import TypeVar

Key = TypeVar("Key", bound=Hashable)


def aligned(lists: Sequence[Sequence[Key]]) -> list[Key]:
    """A short list in which each of the lists is contained, in its order."""
    return reduce(_merged, lists, [])


def places_in(merged: Sequence[Key], part: Sequence[Key]) -> list[int]:
    """Where the members of a list are in one that contains it, each as early as possible."""
    places: list[int] = []
    at = 0
    for key in part:
        while merged[at] != key:
            at += 1
        places.append(at)
        at += 1
    return places


def _merged(first: Sequence[Key], second: Sequence[Key]) -> list[Key]:
    """The shortest list that contains both; common members as early as possible."""
    rows, columns = len(first), len(second)
    common = [[0] * (columns + 1) for _ in range(rows + 1)]
    for i in reversed(range(rows)):
        for j in reversed(range(columns)):
            common[i][j] = (
                common[i + 1][j + 1] + 1
                if first[i] == second[j]
                else max(common[i + 1][j], common[i][j + 1])
            )
    merged: list[Key] = []
    i = j = 0
    while i < rows and j < columns:
        if first[i] == second[j]:
            merged.append(first[i])
            i, j = i + 1, j + 1
        elif common[i + 1][j] >= common[i][j + 1]:
            merged.append(first[i])
            i += 1
        else:
            merged.append(second[j])
            j += 1
    return [*merged, *first[i:], *second[j:]]
