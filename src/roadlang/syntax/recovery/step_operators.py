"""`rise close`: operators whose words may be names too need parentheses around their operand."""

from __future__ import annotations

from ...diagnostics import Code, Fix, diagnose
from ..operators import BY_WORD, OPERATORS
from ..words import CLOSERS, OPENERS
from .error_position import Edit, ErrorPosition, Mistake
from .token_names import finding

_STEPS = frozenset(word for word, operator in BY_WORD.items() if operator.form == "step")
_BEHIND = frozenset(
    operator.word.upper() for operator in OPERATORS if operator.form in ("logic", "binding")
)
"""Operators between formulas: the operand ends before them."""


def bare_operand(place: ErrorPosition) -> Mistake | None:
    """`rise close and p`: the word before is read as a name, and the parser stumbles behind it."""
    operator = place.token(-1)
    if operator[0] != "NAME" or operator[1] not in _STEPS or place.kind() not in _FIRST:
        return None
    last = _last_of_operand(place)
    span = place.span(0, last)
    fixed = f"({span.text})"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(),
        expected="`(`",
        found=finding(place),
        help=f"write `{operator[1]} {fixed}`",
        fixes=[Fix(span, fixed)],
    )
    begin, end = place.index - 1, place.index + last + 1
    inside = place.tokens[place.index : end]
    word = (operator[1].upper(), *operator[1:])
    opening = ("LPAR", "(", span.start, span.start)
    closing = ("RPAR", ")", span.end, span.end)
    return Mistake(found, Edit(begin, end, (word, opening, *inside, closing)))


_FIRST = ("NAME", "NUMBER", "QUOTED", "MINUS")


def _last_of_operand(place: ErrorPosition) -> int:
    """The offset of the last token before the next operator, bracket, brace or line."""
    depth, offset = 0, 0
    while True:
        kind = place.kind(offset + 1)
        is_outside = depth == 0 and (
            kind in _BEHIND or kind in CLOSERS or kind in ("COMMA", "LBRACE")
        )
        if is_outside or place.index + offset + 1 >= len(place.tokens) - 1:
            return offset
        if depth == 0 and place.starts_line(offset + 1):
            return offset
        offset += 1
        depth += (kind in OPENERS) - (kind in CLOSERS)
