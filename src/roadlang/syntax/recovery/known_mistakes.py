"""What is wrong at the place where the parser is stuck, and how reading goes on.

Each known mistake is a function that answers None when it does not recognize its own; the first
answer counts.
"""

from __future__ import annotations

from collections.abc import Callable

from ...diagnostics import Code, diagnose
from ..words import CLOSERS, OPENERS
from .error_position import Edit, ErrorPosition, Mistake
from .expression_habits import (
    absolute_value,
    conditional,
    emit_target,
    function_definition,
    position_range,
    range_word,
    specifier,
)
from .form_mistakes import actor_order, interval_form, list_operand, missing_position
from .number_mistakes import decimal_comma, decimal_point, loose_unit
from .sign_mistakes import (
    one_too_many,
    power_of_python,
    stray_closer,
    turned_comparison,
    wrong_sign,
)
from .token_names import expectation, finding
from .word_mistakes import (
    bare_file_name,
    bare_letter,
    missing_name,
    misspelled_word,
    next_item,
    next_statement,
    reserved_name,
    subscript,
)

_KNOWN: tuple[Callable[[ErrorPosition], Mistake | None], ...] = (
    loose_unit,
    decimal_point,
    decimal_comma,
    subscript,
    conditional,
    function_definition,
    position_range,
    range_word,
    emit_target,
    absolute_value,
    next_item,
    next_statement,
    turned_comparison,
    stray_closer,
    interval_form,
    missing_name,
    wrong_sign,
    power_of_python,
    actor_order,
    missing_position,
    bare_letter,
    misspelled_word,
    reserved_name,
    bare_file_name,
    list_operand,
    specifier,
    one_too_many,
)

_MISSING = (
    ("COLON", ":"),
    ("EQUAL", "="),
    ("WITH", "with"),
    ("IS", "is"),
    ("AT", "at"),
    ("FROM", "from"),
    ("LBRACE", "{"),
    ("LPAR", "("),
    ("LSQB", "["),
)


def explain(place: ErrorPosition) -> Mistake:
    """The mistake at a place where the parser is stuck."""
    for known in _KNOWN:
        mistake = known(place)
        if mistake is not None:
            return mistake
    return unexpected(place)


def unexpected(place: ErrorPosition) -> Mistake:
    """Anything else is here than may be; a sign that is plainly missing is put in."""
    edit, expected = None, place.expected()
    for kind, sign in _MISSING:
        if kind == "COLON" and "COMMA" in expected:
            continue
        if kind in expected and place.goes_on(kind) and _closes_later(place, kind):
            edit = Edit(place.index, place.index, (_token(place, kind, sign),))
            break
    wanted = f"`{edit.tokens[0][1]}`" if edit else expectation(place)
    found = diagnose(Code.UNEXPECTED_TOKEN, place.span(), expected=wanted, found=finding(place))
    return Mistake(found, edit)


def _closes_later(place: ErrorPosition, opener: str) -> bool:
    """An opening bracket is put in only where a closing one waits for it."""
    if opener not in OPENERS:
        return True
    closer = place.unmatched_closer()
    return closer is not None and CLOSERS[closer] == opener


def _token(place: ErrorPosition, kind: str, text: str) -> tuple[str, str, int, int]:
    start = place.token()[2]
    return (kind, text, start, start)
