"""Right of way without circles: vehicles that all yield to one another would wait forever."""

from __future__ import annotations

from collections.abc import Set


def without_circles(yields: Set[tuple[int, int]], count: int) -> set[tuple[int, int]]:
    """Pairs of `count` links, of which the first yields to the second, with as few as possible the
    other way round so that some link always goes first.

    The order is that of the greedy heuristic of Eades, Lin and Smyth (1993).
    """
    place = {link: number for number, link in enumerate(_first_to_last(yields, count))}
    return {
        pair if place[pair[0]] > place[pair[1]] else (pair[1], pair[0]) for pair in sorted(yields)
    }


def _first_to_last(yields: Set[tuple[int, int]], count: int) -> list[int]:
    """Links, those first to which most others yield."""
    left = set(range(count))
    first: list[int] = []
    last: list[int] = []
    while left:
        waits = dict.fromkeys(left, 0)
        is_let = dict(waits)
        for yielding, going in yields:
            if yielding in left and going in left:
                waits[yielding] += 1
                is_let[going] += 1
        free = sorted(link for link in left if not waits[link])
        behind = sorted((link for link in left if waits[link] and not is_let[link]), reverse=True)
        if free:
            first += free
            left -= set(free)
        elif behind:
            last += behind
            left -= set(behind)
        else:
            chosen = max(left, key=lambda link: (is_let[link] - waits[link], -link))
            first.append(chosen)
            left.remove(chosen)
    return first + last[::-1]
