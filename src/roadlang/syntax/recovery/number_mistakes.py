"""Numbers written another way: `5 m`, `5 meters`, `.5`, `1,5m`."""

from __future__ import annotations

import re

from ...diagnostics import Code, Fix, diagnose
from ..unit_words import SPELLED_UNIT, meant_unit
from .error_position import Edit, ErrorPosition, Mistake

_SPACE = re.compile(r"[ \t]+")


def loose_unit(place: ErrorPosition) -> Mistake | None:
    """`5 m`, `5 meters`: the unit is read as a name, and the parser stumbles over it or after it.

    Words between two numbers are looked at from the last of them that the parser could read.
    """
    for offset in (0, -1):
        number = place.token(offset - 1)
        if number[0] != "NUMBER" or place.kind(offset) not in ("NAME",):
            continue
        unit, end = _unit_after(place.source.text, number[3])
        if not unit or not number[1][-1].isdigit():
            continue
        last = place.index + offset
        while place.tokens[last][3] < end:
            last += 1
        if place.tokens[last + 1][0] == "COLON":  # `lanes: 2 s: 3m`, an option of that name
            continue
        span = place.source.span(number[2], end)
        fixed = number[1] + unit
        found = diagnose(
            Code.SPACE_BEFORE_UNIT, span, number=number[1], unit=unit, help=f"write `{fixed}`",
            fixes=[Fix(span, fixed)],
        )  # fmt: skip
        meant = ("NUMBER", fixed, span.start, span.end)
        return Mistake(found, Edit(place.index + offset - 1, last + 1, (meant,)))
    return None


def _unit_after(text: str, start: int) -> tuple[str, int]:
    """The unit that stands here behind a space, and where it ends; "" without one. Of `m per px`
    all is taken, of `m with` only the first word."""
    space = _SPACE.match(text, start)
    match = SPELLED_UNIT.match(text, space.end()) if space else None
    unit = meant_unit(match[0]) if match is not None else None
    return (unit, match.end()) if match is not None and unit is not None else ("", start)


def decimal_point(place: ErrorPosition) -> Mistake | None:
    """`.5`, `5.` and `5.m`: a digit is needed on both sides of the point."""
    if place.kind() != "DOT":
        return None
    first, last, fixed = 0, 0, ""
    if place.wants_value and place.kind(1) == "NUMBER" and place.glued(1):
        last, fixed = 1, "0." + place.word(1)
    elif place.kind(-1) == "NUMBER" and place.glued(0) and place.word(-1).isdigit():
        glued_name = place.kind(1) == "NAME" and place.glued(1)
        first, last = -1, int(glued_name)
        fixed = f"{place.word(-1)}.0{place.word(1) if glued_name else ''}"
    if not fixed:
        return None
    span = place.span(first, last)
    help = f"write `{fixed}`"
    found = diagnose(
        Code.INCOMPLETE_DECIMAL, span, number=span.text, help=help, fixes=[Fix(span, fixed)]
    )
    meant = ("NUMBER", fixed, span.start, span.end)
    return Mistake(found, Edit(place.index + first, place.index + last + 1, (meant,)))


def decimal_comma(place: ErrorPosition) -> Mistake | None:
    """`1,5m`: a comma where the decimal point belongs."""
    if place.kind() != "NUMBER" or place.kind(-1) != "COMMA" or place.kind(-2) != "NUMBER":
        return None
    if not (place.glued(0) and place.glued(-1) and place.word(-2).isdigit()):
        return None
    span = place.span(-2, 0)
    fixed = f"{place.word(-2)}.{place.word()}"
    help = f"write `{fixed}`"
    found = diagnose(
        Code.INCOMPLETE_DECIMAL, span, number=span.text, help=help, fixes=[Fix(span, fixed)]
    )
    meant = ("NUMBER", fixed, span.start, span.end)
    return Mistake(found, Edit(place.index - 2, place.index + 1, (meant,)))


def clock_time(place: ErrorPosition) -> Mistake | None:
    """`14:30`: a time of day is a number of hours."""
    if place.kind() != "COLON" or (place.kind(-1), place.kind(1)) != ("NUMBER", "NUMBER"):
        return None
    hours, minutes = place.word(-1), place.word(1)
    if not (place.glued(0) and place.glued(1) and hours.isdigit() and minutes.isdigit()):
        return None
    fixed = f"{int(hours) + int(minutes) / 60:.6g}h"
    span = place.span(-1, 1)
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        span,
        expected="a value",
        found=f"`{span.text}`",
        help=f"write `{fixed}`",
        fixes=[Fix(span, fixed)],
    )
    meant = ("NUMBER", fixed, span.start, span.end)
    return Mistake(found, Edit(place.index - 1, place.index + 2, (meant,)))
