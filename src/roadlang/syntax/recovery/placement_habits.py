"""Where an agent or object stands, in another order or with a word left out."""

from __future__ import annotations

from ...diagnostics import Code, Fix, diagnose
from ..parsing.tokens import Token
from .error_position import Edit, ErrorPosition, Mistake

_SIDES = ("left", "right")


def position_on_road(place: ErrorPosition) -> Mistake | None:
    """`at main 5m`, `at 5m main`, `at 5m of main`, `on main 5m` and `is car main at 5m`."""
    if place.first_kind not in ("AGENT", "OBJECT"):
        return None
    return (
        _block_before_place(place)
        or _road_after_at(place)
        or _missing_at(place)
        or _missing_on(place)
    )


def _block_before_place(place: ErrorPosition) -> Mistake | None:
    """`is car { length: 5m } on main at 5m`."""
    if place.kind(-1) != "RBRACE" or place.kind() not in ("ON", "AT") or place.starts_line():
        return None
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(),
        expected="the end of the statement",
        found=f"`{place.word()}`",
        help="all options, those of the kind too, are in one block after the position: "
        "`is KIND on ROAD at POSITION { ... }`",
    )
    return Mistake(found)


def _road_after_at(place: ErrorPosition) -> Mistake | None:
    of = place.kind() == "NAME" and place.word() == "of"
    shape = [place.kind(offset) for offset in (-2, -1, int(of))]
    has_road = any(token[0] == "ON" for token in place.tokens[: place.index])
    if has_road or shape not in (["AT", "NAME", "NUMBER"], ["AT", "NUMBER", "NAME"]):
        return None
    first, second = place.token(-1), place.token(int(of))
    road, position = (first, second) if first[0] == "NAME" else (second, first)
    return _rewritten(place, -2, int(of), road, position)


def _missing_at(place: ErrorPosition) -> Mistake | None:
    shape = [place.kind(offset) for offset in (-2, -1, 0)]
    if shape != ["ON", "NAME", "NUMBER"] or place.starts_line():
        return None
    return _rewritten(place, -2, 0, place.token(-1), place.token())


def _missing_on(place: ErrorPosition) -> Mistake | None:
    shape = [place.kind(offset) for offset in (0, 1, 2)]
    if shape != ["NAME", "AT", "NUMBER"] or not place.expects("ON"):
        return None
    return _rewritten(place, 0, 2, place.token(), place.token(2))


def _rewritten(
    place: ErrorPosition, first: int, last: int, road: Token, position: Token
) -> Mistake:
    """The tokens at offsets `first` to `last` as `on ROAD at POSITION`."""
    span = place.span(first, last)
    meant = f"on {road[1]} at {position[1]}"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        span,
        expected="`on ROAD at POSITION`",
        found=f"`{span.text}`",
        help=f"write `{meant}`",
        fixes=[Fix(span, meant)],
    )
    on: Token = ("ON", "on", span.start, span.start)
    at: Token = ("AT", "at", span.start, span.start)
    edit = Edit(place.index + first, place.index + last + 1, (on, road, at, position))
    return Mistake(found, edit)


def sided_offset(place: ErrorPosition) -> Mistake | None:
    """`offset: left 3m` and `offset: 3m left`: the sign of the number says which side."""
    for first in (-1, -2):  # where the parser stops: at the number, or after the side
        pair = [place.token(first), place.token(first + 1)]
        number, side = sorted(pair, key=lambda token: token[0] != "NUMBER")
        if (number[0], place.kind(first - 1)) != ("NUMBER", "COLON") or side[1] not in _SIDES:
            continue
        if place.word(first - 2) != "offset":
            continue
        span, length = place.span(first, first + 1), number[1]
        found = diagnose(
            Code.UNEXPECTED_TOKEN,
            span,
            expected="a length",
            found=f"`{span.text}`",
            help=f"`offset: {length}` is to the left of the middle, `offset: -{length}` to the "
            f"right; `side: {side[1]}, offset: {length}` is outward from the edge of the road",
        )
        return Mistake(found, Edit(place.index + first, place.index + first + 2, (number,)))
    return None
