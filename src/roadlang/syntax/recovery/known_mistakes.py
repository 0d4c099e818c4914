"""What is wrong at the place where the parser is stuck, and how reading goes on.

Each known mistake is a function that answers None when it does not recognize its own; the first
answer counts.
"""

from __future__ import annotations

from collections.abc import Callable

from ...diagnostics import Code, Diagnostic, Fix, diagnose
from ..words import CLOSERS, OPENERS
from .copy_habits import count_before_kind
from .error_position import Edit, ErrorPosition, Mistake
from .expression_habits import (
    absolute_value,
    conditional,
    emit_target,
    function_definition,
    membership,
    method_call,
    options_in_list,
    options_in_parentheses,
    position_range,
    range_word,
    relative_position,
    source_in_parentheses,
    specifier,
    title_of_scenario,
    typed_value,
)
from .form_mistakes import (
    actor_order,
    interval_form,
    list_as_source,
    list_operand,
    name_behind_block,
    option_without_value,
)
from .number_mistakes import clock_time, decimal_comma, decimal_point, loose_unit
from .placement_habits import position_on_road, sided_offset
from .scenic_habits import controllers_in_turn, scenic_operator, scenic_placement
from .sign_mistakes import (
    colon_before_monitor,
    extra_sign,
    long_arrow,
    power_of_python,
    sign_for_word,
    stray_closer,
    third_dot,
    turned_comparison,
    wrong_sign,
)
from .statement_habits import bare_number, foreign_pass_help, json_document, override_with_role
from .step_operators import bare_operand
from .token_names import expectation, finding
from .weighted_choice import weights_map
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
    count_before_kind,
    loose_unit,
    bare_operand,
    list_as_source,
    name_behind_block,
    third_dot,
    clock_time,
    decimal_point,
    decimal_comma,
    subscript,
    controllers_in_turn,
    conditional,
    function_definition,
    membership,
    position_range,
    position_on_road,
    sided_offset,
    weights_map,
    range_word,
    typed_value,
    title_of_scenario,
    source_in_parentheses,
    options_in_parentheses,
    options_in_list,
    relative_position,
    scenic_placement,
    scenic_operator,
    override_with_role,
    bare_number,
    json_document,
    method_call,
    emit_target,
    absolute_value,
    option_without_value,
    next_item,
    next_statement,
    long_arrow,
    turned_comparison,
    stray_closer,
    interval_form,
    missing_name,
    wrong_sign,
    sign_for_word,
    power_of_python,
    actor_order,
    bare_letter,
    misspelled_word,
    reserved_name,
    bare_file_name,
    list_operand,
    specifier,
    colon_before_monitor,
    extra_sign,
)

_MISSING = (
    ("COLON", ":"),
    ("EQUAL", "="),
    ("WITH", "with"),
    ("IS", "is"),
    ("AT", "at"),
    ("AS", "as"),
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
    if "WITH" in expected and foreign_pass_help(place.word(-1)):
        return _foreign_pass(place)
    for kind, sign in _MISSING:
        if kind == "COLON" and "COMMA" in expected:
            continue
        if sign.isalpha() and "NAME" in expected:  # any word may be a name here, as behind a `.`
            continue
        if kind in expected and place.continues(kind) and _closes_later(place, kind):
            edit = Edit(place.index, place.index, (_token(place, kind, sign),))
            break
    if edit is not None:
        return Mistake(_missing(place, edit.tokens[0][1]), edit)
    wanted, found = expectation(place), finding(place)
    return Mistake(diagnose(Code.UNEXPECTED_TOKEN, place.span(), expected=wanted, found=found))


def _missing(place: ErrorPosition, sign: str) -> Diagnostic:
    """A sign or word that is left out: the fix puts it in."""
    glued = sign in (":", "(", "[")
    at = place.token(-1)[3] if glued and place.index else place.token()[2]
    return diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(),
        expected=f"`{sign}`",
        found=finding(place),
        fixes=[Fix(place.source.span(at, at), sign if glued else f"{sign} ")],
    )


def _foreign_pass(place: ErrorPosition) -> Mistake:
    """`behavior pure_pursuit` in a block: the word, not a missing `with`, is what is wrong."""
    word = place.back(-1)
    assert word is not None, "the parser has come this far"
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        word.span(),
        expected="an option",
        found=finding(word),
        help=foreign_pass_help(word.word()),
    )
    return Mistake(found)


def _closes_later(place: ErrorPosition, opener: str) -> bool:
    """An opening bracket is put in only where a closing one waits for it."""
    if opener not in OPENERS:
        return True
    closer = place.unmatched_closer()
    return closer is not None and CLOSERS[closer] == opener


def _token(place: ErrorPosition, kind: str, text: str) -> tuple[str, str, int, int]:
    start = place.token()[2]
    return (kind, text, start, start)
