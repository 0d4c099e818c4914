"""Whether a value fits the type that an option declares; says why where it does not."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from ...diagnostics import Code, Fix
from ...ir.values import Items, Reference, TextValue, Value
from ...plugins import option_types as opt
from ...plugins.describing import word_text
from ...plugins.options import Constraints, OptionSchema
from ..checker import Checker
from ..suggestions import meant_name
from . import expression_types as ty
from .describe_option import describe
from .dimensions import common_dimension, dimension_of, unit_missing
from .matching import matches
from .option_limits import check_limits
from .range_or_interval import other_form

if TYPE_CHECKING:
    from ...ir.dimension import Dimension
    from .expression_types import TypedExpression


def check_assignable(
    checker: Checker, typed: TypedExpression, schema: OptionSchema
) -> TypedExpression | None:
    """The value as the option takes it, or None, reported."""
    if typed.is_unknown:
        return None
    return _checked(checker, typed, schema.type, schema.constraints, f"`{schema.name}`")


def _checked(
    checker: Checker,
    typed: TypedExpression,
    expected: opt.OptionType,
    limits: Constraints,
    what: str,
) -> TypedExpression | None:
    if typed.is_unknown:
        return None
    if isinstance(typed.type, ty.StringType) and _is_word(typed.type, limits):
        if opt.is_list_of_words(expected):
            return _mismatch(checker, typed, expected, limits, what)
        return typed
    match expected:
        case opt.QuantityType():
            return _quantity(checker, typed, expected, limits, what)
        case opt.ListType(item) | opt.IntervalType(item):
            return _sequence(checker, typed, expected, item, limits, what)
        case opt.UnionType(alternatives):
            chosen = next((part for part in alternatives if matches(typed, part)), None)
            if chosen is not None:
                return _checked(checker, typed, chosen, limits, what)
        case opt.WordType():
            return _word(checker, typed, limits, what)
        case opt.NamesType():
            return _names(checker, typed, expected, what)
        case opt.PointType():
            return _point(checker, typed, expected, what)
        case opt.MapType(item):
            return _map(checker, typed, item, limits, what)
        case opt.LikeType() if isinstance(typed.type, ty.Quantity):
            dimension = dimension_of(typed)
            return typed if check_limits(checker, typed, limits, what, dimension) else None
        case _ if matches(typed, expected):
            return typed
    return _mismatch(checker, typed, expected, limits, what)


def _is_word(kind: ty.StringType, limits: Constraints) -> bool:
    """Whether it is one of the words of an option that takes other values too."""
    in_quotes = bool(kind.values) and set(kind.values or ()) <= set(limits.words)
    return bool(limits.words) and (kind.word or in_quotes)


def _mismatch(
    checker: Checker,
    typed: TypedExpression,
    expected: opt.OptionType,
    limits: Constraints,
    what: str,
) -> TypedExpression | None:
    wanted = describe(expected, limits.words)
    help_, fixes = other_form(typed, expected)
    if isinstance(typed.type, ty.SignalType | ty.FormulaType):
        checker.report(
            Code.SIGNAL_AS_NUMBER, typed.span, what=what, expected=wanted, found=typed.type
        )
    elif isinstance(expected, opt.EntityType) and isinstance(typed.type, ty.DeclaredType):
        name = typed.span.text
        checker.report(
            Code.WRONG_ENTITY_TYPE,
            typed.span,
            name=name,
            found=typed.type,
            expected=wanted,
            what=what,
            help=help_,
        )
    else:
        if isinstance(expected, opt.QuantityType) and not help_:
            help_ = _unit_help(expected.dimension, limits)
        checker.report(
            Code.WRONG_TYPE, typed.span, what=what, expected=wanted, found=typed.type,
            help=help_, fixes=fixes,
        )  # fmt: skip
    return None


def _unit_help(wanted: Dimension, limits: Constraints) -> tuple[str, ...]:
    if limits.default_unit:
        return (f"write a value such as `{limits.example}`",)
    return (f"{wanted} has a unit such as `{wanted.unit}`",) if wanted.unit else ()


def _quantity(
    checker: Checker,
    typed: TypedExpression,
    expected: opt.QuantityType,
    limits: Constraints,
    what: str,
) -> TypedExpression | None:
    kind = typed.type
    if not isinstance(kind, ty.Quantity):
        return _mismatch(checker, typed, expected, limits, what)
    if not kind.fits_any and kind.dimension != expected.dimension:
        if kind.bare:
            unit_missing(checker, typed, expected.dimension, limits)
        else:
            wanted, found = expected.dimension, kind.dimension
            checker.report(
                Code.WRONG_DIMENSION, typed.span, what=what, expected=wanted, found=found,
                help=_unit_help(wanted, limits),
            )  # fmt: skip
        return None
    if expected.is_integer and not _is_integer(checker, typed, kind, what):
        return None
    return typed if check_limits(checker, typed, limits, what, expected.dimension) else None


def _is_integer(checker: Checker, typed: TypedExpression, kind: ty.Quantity, what: str) -> bool:
    if kind.is_integer or kind.fits_any:
        return True
    if typed.constant is None and not typed.random:
        return True
    if typed.range:
        low, _, high = typed.span.text.partition("..")
        better = f"integer({low.strip()}, {high.strip()})"
        fixes = [Fix(typed.span, better)]
        help_ = f"`..` draws real numbers; write `{better}`"
        checker.report(Code.NOT_AN_INTEGER, typed.span, what=what, help=help_, fixes=fixes)
    else:
        checker.report(Code.NOT_AN_INTEGER, typed.span, what=what)
    return False


def _sequence(
    checker: Checker,
    typed: TypedExpression,
    expected: opt.ListType | opt.IntervalType,
    item: opt.OptionType,
    limits: Constraints,
    what: str,
) -> TypedExpression | None:
    if not isinstance(typed.type, ty.SequenceType):
        return _mismatch(checker, typed, expected, limits, what)
    pair = isinstance(expected, opt.IntervalType)
    if pair and len(typed.items) != 2:
        return _count(checker, typed, what, "two", len(typed.items))
    if isinstance(expected, opt.ListType) and len(typed.items) < expected.at_least:
        return _count(checker, typed, what, f"{expected.at_least} or more", len(typed.items))
    # Each item has the limits of the option; words stand for the whole, if not for items too.
    inner = limits if opt.takes_words(item) else replace(limits, words=())
    items = [_checked(checker, part, item, inner, f"each item of {what}") for part in typed.items]
    fitted = [part for part in items if part is not None]
    if len(fitted) < len(items):
        return None
    if pair and not _in_order(checker, fitted, typed):
        return None
    return _with_items(typed, fitted)


def _count(
    checker: Checker, typed: TypedExpression, what: str, expected: str, found: int
) -> TypedExpression | None:
    checker.report(
        Code.VALUE_OUT_OF_BOUNDS,
        typed.span,
        what=what,
        expected=f"have {expected} items",
        found=f"has {found}",
    )
    return None


def _in_order(checker: Checker, ends: list[TypedExpression], interval: TypedExpression) -> bool:
    if not all(isinstance(end.type, ty.Quantity) for end in ends):
        return True
    if common_dimension(checker, ends, "the two ends of an interval") is None:
        return False
    low, high = ends[0].constant, ends[1].constant
    if low is not None and high is not None and low > high:
        text = f"[{ends[1].span.text}, {ends[0].span.text}]"
        checker.report(Code.REVERSED_RANGE, interval.span, what="interval", help=f"write `{text}`")
        return False
    return True


def _with_items(typed: TypedExpression, items: list[TypedExpression]) -> TypedExpression:
    value: Value | None = typed.value
    if not isinstance(value, Reference):
        values = tuple(part.value for part in items if part.value is not None)
        value = Items(values) if len(values) == len(items) else None
    return replace(typed, items=tuple(items), value=value)


def _word(
    checker: Checker, typed: TypedExpression, limits: Constraints, what: str
) -> TypedExpression | None:
    kind = typed.type
    if not isinstance(kind, ty.StringType):
        if typed.span.text not in limits.words:
            return _mismatch(checker, typed, opt.WordType(), limits, what)
        quoted = word_text(typed.span.text)
        checker.report(
            Code.WRONG_TYPE,
            typed.span,
            what=what,
            expected=describe(opt.WordType(), limits.words),
            found=kind,
            help=f"write `{quoted}`",
            fixes=(Fix(typed.span, quoted),),
        )
        return None
    wrong = sorted((kind.values or frozenset()) - set(limits.words))
    if not wrong:
        return typed
    words = ", ".join(f"`{word_text(word)}`" for word in limits.words)
    places = [item.span for item in typed.items if item.value == TextValue(wrong[0])]
    place = places[0] if places else typed.span
    is_written = place.text.strip('"') == wrong[0]
    near = meant_name(wrong[0], limits.words) if is_written else None
    meant = None if near is None else word_text(near)
    checker.report(
        Code.UNKNOWN_OPTION_VALUE, place, word=wrong[0], help=f"the words are {words}", meant=meant
    )
    return None


def _names(
    checker: Checker, typed: TypedExpression, expected: opt.NamesType, what: str
) -> TypedExpression | None:
    if matches(typed, expected) and isinstance(typed.type, ty.ConstraintType):
        return replace(typed, value=Items((TextValue(typed.span.text),)))
    if not isinstance(typed.type, ty.SequenceType):
        return _mismatch(checker, typed, expected, Constraints(), what)
    for item in typed.items:
        if not isinstance(item.type, ty.ConstraintType) or not matches(item, expected):
            if not item.is_unknown:
                _mismatch(checker, item, expected, Constraints(), what)
            return None
    names = (TextValue(item.span.text) for item in typed.items)
    return replace(typed, value=Items(tuple(names)))


def _point(
    checker: Checker, typed: TypedExpression, expected: opt.PointType, what: str
) -> TypedExpression | None:
    if not isinstance(typed.type, ty.CoordinatesType):
        return _mismatch(checker, typed, expected, Constraints(), what)
    if typed.items and len(typed.items) != len(expected.parts):
        count = "three" if expected.in_space else "two"
        return _count(checker, typed, what, count, len(typed.items))
    names = ["a coordinate"] * 3
    if expected.second is not None:
        names = [f"the {which} of {what}" for which in ("first number", "second number")]
    items = [
        _checked(checker, item, part, Constraints(), name)
        for item, part, name in zip(typed.items, expected.parts, names, strict=False)
    ]
    fitted = [item for item in items if item is not None]
    return _with_items(typed, fitted) if len(fitted) == len(items) else None


def _map(
    checker: Checker, typed: TypedExpression, item: opt.OptionType, limits: Constraints, what: str
) -> TypedExpression | None:
    if not isinstance(typed.type, ty.MappingType):
        return _mismatch(checker, typed, opt.MapType(item), limits, what)
    fitted = [
        _checked(checker, part, item, limits, f"each entry of {what}") for part in typed.items
    ]
    return typed if all(part is not None for part in fitted) else None
