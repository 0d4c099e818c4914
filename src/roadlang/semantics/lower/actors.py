"""Agents and objects: what they are, where they stand, who drives."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code
from ...ir import scenario as ir
from ...ir.dimension import LENGTH, PURE
from ...ir.read_only import FrozenDict
from ...ir.values import (
    NO_OPTIONS,
    ConstantValue,
    Entity,
    Options,
    PassCall,
    RandomValue,
    Reference,
)
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.actor_kinds import calls_in, shared_options, with_options
from ..infer.blocks import lower_options, lower_passes
from ..infer.inherited_roads import road_of
from ..infer.kinds import find_default
from ..infer.option_binding import divided
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
    if on is None and not _fits_without_road(checker, statement):
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
    """The road's name, None without one, False where it was reported. By another (`ahead_of`) it is
    that of the other."""
    named = road_of(checker, statement)
    if named is None:
        return None
    typed = checker.infer(named, context)
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
    inner = replace(context, place=f"{context.place}/at")
    if isinstance(statement.at, ast.Name) and statement.at.text == "random":
        return _anywhere(checker, statement, inner)
    typed = checker.infer(statement.at, inner)
    if typed.is_unknown:
        return None
    if isinstance(typed.type, KindCallType) and typed.type.verb == "position":
        return _by_another(checker, statement, typed)
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


def _anywhere(checker: Checker, statement: ast.Actor, context: Context) -> TypedExpression | None:
    """`at random`: what `at 0%..100%` says."""
    span = statement.at.span
    if statement.on is None:
        checker.report(Code.ARC_LENGTH_WITHOUT_ROAD, span, name=statement.name.text)
        return None
    found = find_default(checker, "distribution", span)
    if found is None:
        return None
    place = checker.draw_place(context)
    ends: Options = FrozenDict({"low": ConstantValue(0.0), "high": ConstantValue(1.0)})
    call = PassCall("distribution", found.entry.qualified, ends, place, span)
    value = RandomValue(place, call, context.per, PURE)
    return TypedExpression(span, Quantity(PURE), value, random=True, bounds=(0.0, 1.0))


def _by_another(
    checker: Checker, statement: ast.Actor, typed: TypedExpression
) -> TypedExpression | None:
    """A position by another agent or object, which is on the same road."""
    assert isinstance(typed.value, PassCall)
    for value in typed.value.options.values():
        if isinstance(value, Entity) and value.role in ("agent", "object"):
            other = checker.program.declarations[value.name].statement
            assert isinstance(other, ast.Actor)
            road, own = road_of(checker, other), road_of(checker, statement)
            if road is None or own is None:
                name, member = value.name, "place on a road"
                checker.report(Code.START_WITHOUT_ROAD, typed.span, name=name, member=member)
                return None
            if road.span.text != own.span.text:
                help_ = f"place it on `{road.span.text}`, or leave out `on`"
                checker.report(
                    Code.OTHER_ROAD,
                    typed.span,
                    name=statement.name.text,
                    other=value.name,
                    road=road.span.text,
                    help=help_,
                )
                return None
    return typed


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
) -> tuple[Options | None, Options]:
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
    if "spacing" in bound.given and "count" not in bound.given:
        span = bound.given["spacing"].span
        checker.report(Code.SPACING_WITHOUT_COUNT, span, name=statement.name.text)
        return None, NO_OPTIONS
    if "lane" in bound.given and "side" in bound.given:
        checker.report(Code.LANE_AND_SIDE, bound.given["side"].span)
        return None, NO_OPTIONS
    placement, rest = divided(bound.values, names)
    return (placement if bound.complete else None), rest


def replace_required(option: OptionSchema) -> OptionSchema:
    """An option that the call of the kind may have given already."""
    return replace(option, default=None) if option.required else option


def _fits_without_road(checker: Checker, statement: ast.Actor) -> bool:
    for option in statement.block.options if statement.block else ():
        if option.key.text in ("lane", "side", "offset", "facing", "spacing"):
            name, key = statement.name.text, option.key
            checker.report(Code.OPTION_NEEDS_ROAD, key.span, name=name, option=key.text)
            return False
    return True
