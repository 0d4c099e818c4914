"""The number of agents or objects, written in front of their kind: `is 300 car on main`."""

from __future__ import annotations

from ...diagnostics import Code, diagnose
from ..parsing.grammar import END
from .error_position import Edit, ErrorPosition, Mistake


def count_before_kind(place: ErrorPosition) -> Mistake | None:
    """`agent traffic is 300 of car on main`, and `300 of car on main` on a line of its own."""
    if place.kind() != "NUMBER" or not place.word().isdigit():
        return None
    last = 1 if place.word(1) in ("of", "x", "*", "times") else 0
    if place.kind(last + 1) != "NAME":
        return None
    if place.first_kind in ("AGENT", "OBJECT") and place.kind(-1) == "IS":
        return _after_is(place, last)
    if place.starts_line() and place.kind(last + 2) in ("ON", "AT"):
        return _line_of_its_own(place, last)
    return None


def _after_is(place: ErrorPosition, last: int) -> Mistake:
    kind = place.word(last + 1)
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(0, last),
        expected="a kind",
        found=f"`{place.span(0, last).text}`",
        help=f"write `is {kind}`, and `count: {place.word()}` in its block",
    )
    return Mistake(found, Edit(place.index, place.index + last + 1))


def _line_of_its_own(place: ErrorPosition, last: int) -> Mistake:
    kind = place.word(last + 1)
    end = 0
    while place.kind(end + 1) != END and not place.starts_line(end + 1):
        end += 1
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(0, last + 1),
        expected="a statement",
        found=f"`{place.span(0, last + 1).text}`",
        help=f"write `agent NAME is {kind} on ROAD at 10m..100m {{ count: {place.word()} }}`",
    )
    return Mistake(found, Edit(place.index, place.index + end + 1))
