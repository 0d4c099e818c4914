"""Intervals, lists and agents in another form than the language has."""

from __future__ import annotations

from ...diagnostics import Code, Fix, diagnose
from ..operators import OPERATORS
from ..parsing.grammar import END
from ..words import BINDING_KINDS, PASS_VERBS, TEMPORAL_KINDS
from .error_position import Edit, ErrorPosition, Mistake

STEPS = frozenset(operator.word for operator in OPERATORS if operator.form == "step")
"""Operators without an interval"""
_OPERANDS = TEMPORAL_KINDS | {"NAME", "NUMBER", "NOT"}
"""What follows `always(0s..5s)` without parentheses; that may be an operand itself"""
_TWO_NUMBERS = (["NUMBER", "COMMA", "NUMBER"], ["NUMBER", "RANGE", "NUMBER"])


def interval_form(place: ErrorPosition) -> Mistake | None:
    """`always[0s..5s]`, `always[5s]`, `always(0s, 5s) (p)`, `always(0s..5s) p`."""
    if place.kind(-1) == "RPAR" and place.kind() in _OPERANDS | {"LPAR"}:
        return _round_interval(place)
    if place.kind() == "COMMA" and place.expects("RSQB") and place.word(-3) in STEPS:
        return _interval_of_step(place)
    if place.kind() != "RSQB" or not place.expects("COMMA") or place.expects("RSQB"):
        return None
    opener = _opener(place, place.index, "LSQB", "RSQB")
    if opener is None or place.tokens[opener - 1][0] not in TEMPORAL_KINDS | BINDING_KINDS:
        return None
    inside = range(opener + 1, place.index)
    dots = [index for index in inside if place.tokens[index][0] == "RANGE"]
    span = place.source.span(place.tokens[opener][2], place.token()[3])
    if dots:
        fixed = span.text.replace("..", ", ", 1)
        found = diagnose(
            Code.MALFORMED_INTERVAL, span, help=f"write `{fixed}`", fixes=[Fix(span, fixed)]
        )
        dot = place.tokens[dots[0]]
        return Mistake(found, Edit(dots[0], dots[0] + 1, (("COMMA", ",", dot[2], dot[3]),)))
    zero = "[0, " + span.text[1:].strip()
    found = diagnose(
        Code.MALFORMED_INTERVAL, span, help=f"from now on: `{zero}`", fixes=[Fix(span, zero)]
    )
    start = place.tokens[opener][3]
    low = (("NUMBER", "0", start, start), ("COMMA", ",", start, start))
    return Mistake(found, Edit(opener + 1, opener + 1, low))


def option_without_value(place: ErrorPosition) -> Mistake | None:
    """`{ lanes }`, `{ count 5 }`, and a unit written twice: `{ scale: 8m/px px }`."""
    if place.kind() not in ("COMMA", "RBRACE", "NUMBER") or place.kind(-1) != "NAME":
        return None
    name, before = place.word(-1), place.token(-2)
    if name in PASS_VERBS or not place.expects("COLON") or not place.in_block:
        return None
    if before[0] == "NUMBER" and before[1].endswith(name):
        help_ = f"`{before[1]}` already has its unit: leave out `{name}`"
    else:
        value = place.word() if place.kind() == "NUMBER" else "VALUE"
        help_ = f"write `{name}: {value}`"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(-1) if place.kind() != "NUMBER" else place.span(),
        expected=f"`:` and a value after `{name}`" if place.kind() != "NUMBER" else "`:`",
        found=f"`{place.word()}`",
        help=help_,
    )
    if place.kind() == "NUMBER":
        colon = ("COLON", ":", place.token()[2], place.token()[2])
        return Mistake(found, Edit(place.index, place.index, (colon,)))
    return Mistake(found, culprit=place.index - 1)


def _round_interval(place: ErrorPosition) -> Mistake | None:
    opener = _opener(place, place.index - 1, "LPAR", "RPAR")
    if opener is None or place.tokens[opener - 1][0] not in TEMPORAL_KINDS | BINDING_KINDS:
        return None
    inside = list(place.tokens[opener + 1 : place.index - 1])
    kinds = [kind for kind, *_ in inside]
    if place.kind() != "LPAR" and kinds not in _TWO_NUMBERS:
        return None
    span = place.source.span(place.tokens[opener][2], place.token(-1)[3])
    fixed = f"[{span.text[1:-1].replace('..', ', ', 1)}]"
    found = diagnose(
        Code.MALFORMED_INTERVAL, span, help=f"write `{fixed}`", fixes=[Fix(span, fixed)]
    )
    if "RANGE" in kinds:
        dots = kinds.index("RANGE")
        inside[dots] = ("COMMA", ",", *inside[dots][2:])
    first, last = place.tokens[opener], place.token(-1)
    tokens = (("LSQB", "[", first[2], first[3]), *inside, ("RSQB", "]", last[2], last[3]))
    return Mistake(found, Edit(opener, place.index, tokens))


def _interval_of_step(place: ErrorPosition) -> Mistake:
    """`next[0, 1] (p)`."""
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.source.span(place.token(-2)[2], place.token()[3]),
        expected=f"an operand of `{place.word(-3)}`",
        found="an interval",
        help=f"`{place.word(-3)}` counts samples, not time: leave the interval out",
    )
    return Mistake(found, hopeless=True)


def _opener(place: ErrorPosition, closer: int, opens: str, closes: str) -> int | None:
    depth = 0
    for index in range(closer, 0, -1):
        depth += (place.tokens[index][0] == closes) - (place.tokens[index][0] == opens)
        if depth == 0:
            return index
    return None


def list_operand(place: ErrorPosition) -> Mistake | None:
    """A list next to an operator, or where an operand is expected."""
    after_list = place.kind(-1) == "RSQB" and place.kind() in (
        "PLUS", "MINUS", "TIMES", "DIVIDE", "COMPARISON", "RANGE", "POWER", "AND", "OR",
    )  # fmt: skip
    before = place.kind() == "LSQB" and place.wants_value
    if not after_list and not before:
        return None
    numbers = [place.kind(offset) for offset in range(1, 5)] == _PAIR
    if before and numbers and place.kind(-1) in _ARITHMETIC:
        return _range_as_operand(place)
    return Mistake(diagnose(Code.LIST_AS_OPERAND, place.span()))


def list_as_source(place: ErrorPosition) -> Mistake | None:
    """`road r from [a, b]`, `network n from [a, b]`: several roads are no source."""
    if place.kind() != "LSQB" or place.kind(-1) != "FROM":
        return None
    names, offset = [], 1
    while place.kind(offset) == "NAME":
        names.append(place.word(offset))
        offset += 2 if place.kind(offset + 1) == "COMMA" else 1
    joined = f"{names[0] if names else 'a'} {{ then: [{', '.join(names[1:]) or 'b'}] }}"
    help_ = f"`road NAME from {joined}` joins roads end to end"
    if place.first_kind == "NETWORK":
        help_ = f"a network is made from an image, a map file or another network; {help_}"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(),
        expected="a name or a string in double quotes",
        found="`[`",
        help=help_,
    )
    return Mistake(found, hopeless=True)


def name_behind_block(place: ErrorPosition) -> Mistake | None:
    """`sense with ranges { ... } as front`: the name of a pass stands before its block."""
    if (place.kind(-1), place.kind(), place.kind(1)) != ("RBRACE", "AS", "NAME"):
        return None
    opener = _opener(place, place.index - 1, "LBRACE", "RBRACE")
    if opener is None or opener < 3 or place.tokens[opener - 2][0] != "WITH":
        return None
    named, block = place.tokens[place.index : place.index + 2], place.tokens[opener : place.index]
    start, name = place.tokens[opener - 3][2], place.word(1)
    before = place.source.span(start, place.tokens[opener - 1][3]).text
    moved = place.source.span(place.tokens[opener][2], place.token(1)[3])
    inside = place.source.span(moved.start, place.token(-1)[3]).text
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(0, 1),
        expected="the name before the block",
        found=f"`as {name}`",
        help=f"write `{before} as {name} {{ ... }}`",
        fixes=[Fix(moved, f"as {name} {inside}")],
    )
    return Mistake(found, Edit(opener, place.index + 2, (*named, *block)))


def actor_order(place: ErrorPosition) -> Mistake | None:
    """`is K at P on R`: the order is fixed."""
    if place.first_kind not in ("AGENT", "OBJECT") or place.kind() not in ("ON", "IS"):
        return None
    kinds = [token[0] for token in place.tokens[: place.index]]
    if place.kind() != "ON" or "AT" not in kinds or "ON" in kinds:
        return None
    at = kinds.index("AT")
    end = place.index + 1
    while place.tokens[end][0] not in ("LBRACE", END):
        end += 1
    moved = (*place.tokens[place.index : end], *place.tokens[at : place.index])
    found = diagnose(
        Code.WRONG_CLAUSE_ORDER,
        place.span(),
        help="the order is `is KIND on ROAD at PLACE { ... }`",
    )
    return Mistake(found, Edit(at, end, moved))


def _range_as_operand(place: ErrorPosition) -> Mistake:
    """`ego.start + [20m, 60m]`, where a draw is meant."""
    span, low, high, comma = place.span(0, 4), place.token(1), place.token(3), place.token(2)
    meant = f"({low[1]}..{high[1]})"
    help = f"to draw a value between the two, write `{meant}`"
    found = diagnose(Code.LIST_AS_OPERAND, span, help=help, fixes=[Fix(span, meant)])
    opening = ("LPAR", "(", span.start, span.start)
    closing = ("RPAR", ")", span.end, span.end)
    tokens = (opening, low, ("RANGE", "..", comma[2], comma[3]), high, closing)
    return Mistake(found, Edit(place.index, place.index + 5, tokens))


_PAIR = ["NUMBER", "COMMA", "NUMBER", "RSQB"]
_ARITHMETIC = ("PLUS", "MINUS", "TIMES", "DIVIDE")
