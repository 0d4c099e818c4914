"""Agents and objects: what they are, where they stand, who drives."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code
from ...ir import scenario as ir
from ...ir.dimension import LENGTH
from ...ir.values import Entity, Reference, Value
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.actor_kinds import calls_in, shared_options, with_options
from ..infer.blocks import lower_options, lower_passes
from ..infer.statement_spec import StatementSpec
from ..names.program import Declaration
from ..types.dimensions import unit_missing
from ..types.expression_types import (
    CoordinatesType,
    DeclaredType,
    KindCallType,
    Quantity,
    TypedExpression,
)


def lower_actor(
    checker: Checker, spec: StatementSpec, declaration: Declaration
) -> ir.ScenarioActor | None:
    """The statement, or None, reported."""
    statement = declaration.statement
    assert isinstance(statement, ast.Actor)
    name = statement.name.text
    copies = _has_count(statement)
    context = Context(user=name, place=name, per="copy" if copies else "scene")
    kind = _kind(checker, statement, context)
    on = _road(checker, statement, context)
    at = _place(checker, statement, context)
    placement, kind_options = _options(checker, statement, spec, kind, context)
    drive = lower_passes(checker, spec, statement.block, context)
    if statement.block is not None and not statement.block.complete:
        return None
    if kind is None or kind.value is None or on is False or at is None or at.value is None:
        return None
    if placement is None or drive is None:
        return None
    if statement.on is None and not _fits_without_road(checker, statement):
        return None
    value = with_options(checker, kind.value, kind_options)
    fraction = isinstance(at.type, Quantity) and at.type.dimension.is_pure and not at.type.fits_any
    road = on if isinstance(on, str) else None
    return ir.ScenarioActor(name, value, road, at.value, fraction, placement, drive, statement.span)


def _has_count(statement: ast.Actor) -> bool:
    return statement.block is not None and any(
        option.key.text == "count" for option in statement.block.options
    )


def _kind(checker: Checker, statement: ast.Actor, context: Context) -> TypedExpression | None:
    word = statement.word
    inner = replace(context, place=f"{context.place}/kind", verbs=(word,))
    typed = checker.infer(statement.kind, inner)
    if typed.is_unknown:
        return None
    if not isinstance(typed.type, KindCallType) or typed.type.verb != word:
        expected = f"a kind of {word}"
        checker.report(
            Code.WRONG_TYPE, typed.span, what=f"`{word}`", expected=expected, found=typed.type
        )
        return None
    while isinstance(typed.value, Reference):
        typed = replace(checker.definition(typed.value.name), span=typed.span)
    return typed


def _road(checker: Checker, statement: ast.Actor, context: Context) -> str | bool | None:
    """The road's name, None without one, False where it was reported."""
    if statement.on is None:
        return None
    typed = checker.infer(statement.on, context)
    if typed.is_unknown:
        return False
    if isinstance(typed.type, DeclaredType) and typed.type.role == "road":
        assert isinstance(typed.value, Entity)
        return typed.value.name
    what, found = "`on`", typed.type
    if isinstance(typed.type, DeclaredType):
        name = typed.span.text
        help_ = (
            f"choose one of its roads: `road street from {name}`"
            if typed.type.role == "network"
            else ()
        )
        checker.report(
            Code.WRONG_ENTITY_TYPE,
            typed.span,
            name=name,
            found=found,
            expected="a road",
            what=what,
            help=help_,
        )
    else:
        checker.report(Code.WRONG_TYPE, typed.span, what=what, expected="a road", found=found)
    return False


def _place(checker: Checker, statement: ast.Actor, context: Context) -> TypedExpression | None:
    """`at`: along the road, a share of it, or a point in the world."""
    typed = checker.infer(statement.at, replace(context, place=f"{context.place}/at"))
    if typed.is_unknown:
        return None
    if isinstance(typed.type, CoordinatesType):
        return _point(checker, statement, typed)
    if not isinstance(typed.type, Quantity):
        expected = "a length or a share of the road" if statement.on else "a point `(x, y)`"
        checker.report(
            Code.WRONG_TYPE, typed.span, what="`at`", expected=expected, found=typed.type
        )
        return None
    if statement.on is None:
        checker.report(Code.ARC_LENGTH_WITHOUT_ROAD, typed.span, name=statement.name.text)
        return None
    if typed.type.fits_any or typed.type.dimension == LENGTH:
        return typed
    if typed.type.bare:
        unit_missing(checker, typed, LENGTH)
        return None
    if typed.type.dimension.is_pure:
        return typed
    expected = "a length or a share of the road"
    checker.report(
        Code.WRONG_DIMENSION, typed.span, what="`at`", expected=expected, found=typed.type.dimension
    )
    return None


def _point(
    checker: Checker, statement: ast.Actor, typed: TypedExpression
) -> TypedExpression | None:
    from ...plugins.option_types import PointType as PointOption
    from ...plugins.options import Constraints
    from ..types.assignable import check_assignable

    if statement.on is not None:
        checker.report(Code.POINT_ON_ROAD, typed.span, name=statement.name.text)
        return None
    schema = OptionSchema("at", PointOption(LENGTH), None, Constraints())
    return check_assignable(checker, typed, schema)


def _options(
    checker: Checker,
    statement: ast.Actor,
    spec: StatementSpec,
    kind: TypedExpression | None,
    context: Context,
) -> tuple[tuple[tuple[str, Value], ...] | None, tuple[tuple[str, Value], ...]]:
    """The options of the placement (None, reported, where wrong), and those of the kind."""
    calls = calls_in(kind.value) if kind is not None and kind.value is not None else []
    shared = shared_options(checker, calls)
    names = {option.name for option in spec.schema}
    block = statement.block
    if block is not None and kind is None:
        # Without the kind nobody knows its options: look at those of the placement only.
        known = tuple(option for option in block.options if option.key.text in names)
        block = ast.Block(known, span=block.span)
    extra = [replace_required(option) for option in shared if option.name not in names]
    bound = lower_options(
        checker, statement.word, block, [*spec.schema, *extra], context, statement.name.span
    )
    if "lane" in bound.given and "side" in bound.given:
        checker.report(Code.LANE_AND_SIDE, bound.given["side"].span)
        return None, ()
    placement = tuple((name, value) for name, value in bound.values if name in names)
    rest = tuple((name, value) for name, value in bound.values if name not in names)
    return (placement if bound.complete else None), rest


def replace_required(option: OptionSchema) -> OptionSchema:
    """An option that the call of the kind may have given already."""
    return replace(option, default=None) if option.required else option


def _fits_without_road(checker: Checker, statement: ast.Actor) -> bool:
    assert statement.on is None
    for option in statement.block.options if statement.block else ():
        if option.key.text in ("lane", "side", "offset", "facing"):
            name, key = statement.name.text, option.key
            checker.report(Code.OPTION_NEEDS_ROAD, key.span, name=name, option=key.text)
            return False
    return True
