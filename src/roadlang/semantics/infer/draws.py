"""Random values written as calls: what type they have, and between which numbers they are."""

from __future__ import annotations

from typing import Any

from ...diagnostics import Code, DiagnosticError
from ...ir.dimension import PURE
from ...ir.values import ConstantValue, Items, PassCall, RandomValue, Value
from ...plugins.option_types import ListType, QuantityType, is_of_anything
from ...plugins.stated_bounds import stated_support
from ...syntax.tree import nodes as ast
from ..checker import Checker, ResolvedKind
from ..context import Context
from ..types import expression_types as ty
from ..types.dimensions import common_dimension, dimension_of
from ..types.expression_types import TypedExpression, unknown
from .option_binding import BoundOptions


def draw_of(
    checker: Checker,
    call: ast.CallExpression,
    found: ResolvedKind,
    bound: BoundOptions,
    context: Context,
) -> TypedExpression:
    """The draw that the call of a distribution stands for."""
    kind = _type_of(checker, found, bound)
    if kind is None:
        return unknown(call.span)
    place = checker.draw_place(context)
    options = bound.values
    name, spans = found.entry.qualified, bound.spans
    drawn = PassCall("distribution", name, options, place, call.span, option_spans=spans)
    if _is_reversed(checker, drawn, found):
        return checker.report(
            Code.REVERSED_RANGE, call.span, what="range", help="the lower end comes first"
        )
    dimension = kind.dimension if isinstance(kind, ty.Quantity) else PURE
    value = RandomValue(place, drawn, context.per, dimension)
    bounds = checker.bounds_of(value)
    return TypedExpression(
        call.span, kind, value, random=True, bounds=bounds, items=_items(found, bound)
    )


def _items(found: ResolvedKind, bound: BoundOptions) -> tuple[TypedExpression, ...]:
    """What is chosen among, so that the parts of a random list or point can be checked."""
    chosen = _chosen(found, bound)
    if chosen and all(
        isinstance(part.type, ty.SequenceType | ty.CoordinatesType) for part in chosen
    ):
        return chosen[0].items
    return chosen if chosen and isinstance(chosen[0].type, ty.StringType) else ()


def _chosen(found: ResolvedKind, bound: BoundOptions) -> tuple[TypedExpression, ...]:
    for option in found.schema:
        if option.name in bound.stated and is_of_anything(option.type):
            stated = bound.stated[option.name]
            return stated.items if isinstance(option.type, ListType) else (stated,)
    return ()


def _type_of(checker: Checker, found: ResolvedKind, bound: BoundOptions) -> ty.Type | None:
    if bound.like is not None:
        return ty.Quantity(dimension_of(bound.like))
    chosen = _chosen(found, bound)
    if chosen:
        return _common_type(checker, chosen)
    numbers = [option.type for option in found.schema if isinstance(option.type, QuantityType)]
    is_integer = bool(numbers) and all(number.is_integer for number in numbers)
    return ty.Quantity(PURE, is_integer=is_integer)


def _common_type(checker: Checker, parts: tuple[TypedExpression, ...]) -> ty.Type | None:
    """The type of any of several values; None, reported, where they have not one."""
    first = parts[0]
    kinds = [part.type for part in parts if isinstance(part.type, ty.KindCallType)]
    if kinds and all(part.type == kinds[0] or _is_word(part) for part in parts):
        return kinds[0]
    numbers = tuple(part for part in parts if isinstance(part.type, ty.Quantity))
    if numbers and all(
        part in numbers or _is_word(part) or isinstance(part.type, ty.KindCallType)
        for part in parts
    ):
        parts, first = numbers, numbers[0]  # an option that takes both, such as `lane`
    for part in parts[1:]:
        if type(part.type) is not type(first.type) or (
            isinstance(part.type, ty.KindCallType) and part.type != first.type
        ):
            what = "each value to choose from"
            checker.report(
                Code.WRONG_TYPE, part.span, what=what, expected=first.type, found=part.type
            )
            return None
    if isinstance(first.type, ty.Quantity):
        dimension = common_dimension(checker, parts, "chosen from")
        is_integer = all(
            isinstance(part.type, ty.Quantity) and part.type.is_integer for part in parts
        )
        bare = all(isinstance(part.type, ty.Quantity) and part.type.bare for part in parts)
        return (
            None if dimension is None else ty.Quantity(dimension, is_integer=is_integer, bare=bare)
        )
    if isinstance(first.type, ty.StringType):
        texts = [part.type.values for part in parts if isinstance(part.type, ty.StringType)]
        known = [values for values in texts if values is not None]
        return ty.StringType(frozenset().union(*known) if len(known) == len(texts) else None)
    return first.type


def _is_word(part: TypedExpression) -> bool:
    """Whether it is a word of the option, such as `outer` beside the kinds of lanes."""
    return isinstance(part.type, ty.StringType) and part.type.word


def _is_reversed(checker: Checker, call: PassCall, found: ResolvedKind) -> bool:
    """Whether the distribution states a least value above the greatest, of these very options."""
    options = checker.value_bounds.options(call)
    try:
        low, high = stated_support(found.entry, found.kind, options, call.span)
    except DiagnosticError:  # a plugin's mistake shows when it draws, with its name
        return False
    return low > high


def constant_of(value: Value) -> Any:
    """A constant number, or a tuple of them; None for anything else."""
    if isinstance(value, ConstantValue):
        return value.value
    if isinstance(value, Items):
        parts = tuple(constant_of(item) for item in value.items)
        return None if any(part is None for part in parts) else parts
    return None
