"""Signs and brackets: the wrong one, one too many, or another language's."""

from __future__ import annotations

from ...diagnostics import Code, Fix, diagnose
from ..words import CLOSERS
from .error_position import Edit, ErrorPosition, Mistake
from .token_names import finding
from .unexpected import unexpected

_NAMED = ("IMAGE", "NETWORK", "ROAD", "AGENT", "OBJECT")
"""Statements whose name is followed by a word."""


def wrong_sign(place: ErrorPosition) -> Mistake | None:
    """`=` for `:`, `:` for `=`, `=` for `==`."""
    kind = place.kind()
    if kind not in ("EQUAL", "COLON"):
        return None
    for meant, sign in (("COLON", ":"), ("EQUAL", "="), ("COMPARISON", "==")):
        if meant != kind and place.expects(meant) and (kind == "EQUAL" or meant == "EQUAL"):
            span = place.span()
            last = 1
            if place.kind(1) == "EQUAL" and place.glued(1):
                last = 2
            found = diagnose(
                Code.WRONG_ASSIGNMENT_OPERATOR,
                span,
                right=sign,
                wrong=place.word(),
                help=f"write `{sign}`",
                fixes=[Fix(span, sign)],
            )
            token = (meant, sign, span.start, span.end)
            return Mistake(found, Edit(place.index, place.index + last, (token,)))
    return None


def sign_for_word(place: ErrorPosition) -> Mistake | None:
    """`network town = photo`, `agent ego: car` and `ego = new Car`: a sign where a word belongs."""
    after_name = place.index == 2 and place.first_kind in _NAMED
    if place.kind() != "EQUAL" and not (place.kind() == "COLON" and after_name):
        return None
    word = next((word for word in ("from", "is") if place.expects(word.upper())), None)
    if word is None:
        return None
    last = int(word == "is" and place.word(1) == "new" and place.kind(2) == "NAME")
    if not last and not place.continues(word.upper(), skip=1):
        return None
    span = place.span(0, last)
    found = diagnose(
        Code.UNEXPECTED_TOKEN, span, expected=f"`{word}`", found=finding(place),
        help=f"write `{word}`", fixes=[Fix(span, word)],
    )  # fmt: skip
    token = (word.upper(), word, span.start, span.end)
    return Mistake(found, Edit(place.index, place.index + last + 1, (token,)))


def third_dot(place: ErrorPosition) -> Mistake | None:
    """`0m...5m`: a range has two dots."""
    if place.kind() != "DOT" or place.kind(-1) != "RANGE" or not place.glued(0):
        return None
    span = place.span(-1, 0)
    found = diagnose(
        Code.UNEXPECTED_TOKEN, span, expected="`..`", found="`...`",
        help="a range is written with two dots", fixes=[Fix(span, "..")],
    )  # fmt: skip
    return Mistake(found, Edit(place.index, place.index + 1))


def stray_closer(place: ErrorPosition) -> Mistake | None:
    """A closing bracket that nothing opens."""
    if place.kind() not in CLOSERS:
        return None
    depth = 0
    for token in place.tokens[: place.index]:
        depth += (token[0] == CLOSERS[place.kind()]) - (token[0] == place.kind())
    if depth > 0:
        return None
    help = "leave it out, or open it where it belongs"
    found = diagnose(Code.UNMATCHED_BRACKET, place.span(), what=place.word(), help=help)
    return Mistake(found, Edit(place.index, place.index + 1))


def colon_before_monitor(place: ErrorPosition) -> Mistake | None:
    """`expect calm: with comfort { ... }`: a colon stands before formulas alone."""
    if place.first_kind not in ("REQUIRE", "EXPECT") or place.index != 3:
        return None
    if (place.kind(-1), place.kind()) != ("COLON", "WITH"):
        return None
    span = place.span(-1, -1)
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        span,
        expected="`with`",
        found="`:`",
        help=f"write `{place.word(-3)} {place.word(-2)} with {place.word(1)}`",
        fixes=[Fix(span, "")],
    )
    return Mistake(found, Edit(place.index - 1, place.index))


def extra_sign(place: ErrorPosition) -> Mistake | None:
    """A comma or a `with` that can be left out."""
    if place.kind() not in ("COMMA", "WITH") or not place.continues(skip=1):
        return None
    help = "leave it out"
    if place.kind() == "WITH" and place.kind(1) == "NAME":
        help = f"write `{place.word(-1)} {place.word(1)}`"
    return unexpected(place, help, edit=Edit(place.index, place.index + 1))


def power_of_python(place: ErrorPosition) -> Mistake | None:
    """`**`, which is written `^` here."""
    if place.kind() != "TIMES" or place.kind(-1) != "TIMES" or not place.glued(0):
        return None
    return _two_signs(place, -1, "**", ("POWER", "^"), "a power is written with `^`")


def turned_comparison(place: ErrorPosition) -> Mistake | None:
    """`=<` for `<=`."""
    if place.kind() != "EQUAL" or place.word(1) != "<" or not place.glued(1):
        return None
    return _two_signs(place, 0, "=<", ("COMPARISON", "<="), "write `<=`")


def long_arrow(place: ErrorPosition) -> Mistake | None:
    """`p ==> q`, where `implies` is meant."""
    if place.word() != ">" or place.word(-1) != "==" or not place.glued(0):
        return None
    return _two_signs(place, -1, "==>", ("IMPLIES", "implies"), "write `implies`")


def _two_signs(
    place: ErrorPosition, first: int, written: str, meant: tuple[str, str], help: str
) -> Mistake:
    """Two tokens, the first of them `first` after the place, in place of one: its kind and text."""
    span, (kind, text) = place.span(first, first + 1), meant
    found = diagnose(
        Code.UNEXPECTED_CHARACTER, span, what=written, help=help, fixes=[Fix(span, text)]
    )
    start = place.index + first
    return Mistake(found, Edit(start, start + 2, ((kind, text, span.start, span.end),)))
