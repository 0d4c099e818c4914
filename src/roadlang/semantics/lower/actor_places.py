"""Where an agent or object is: along a road, by another, at a point, or where its route begins."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code, Span, nearest
from ...ir.dimension import LENGTH, PURE
from ...ir.read_only import FrozenDict
from ...ir.values import (
    ConstantValue,
    Entity,
    Items,
    Options,
    PassCall,
    RandomValue,
    Value,
)
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.habits import position_help
from ..infer.inherited_roads import goes_in_circles, road_of
from ..infer.kinds import find_default
from ..types.dimensions import unit_missing
from ..types.expression_types import CoordinatesType, KindCallType, Quantity, TypedExpression

PLACED_ON = ("road", "network")
"""What agents and objects are on"""


def place_of(
    checker: Checker,
    statement: ast.Actor,
    context: Context,
    network: str | None,
    route: Value | None,
) -> TypedExpression | None:
    """`at`: along the road, a share of it, or a point in the world. In a network a point too, or
    `random`; without `at` where the `route` begins. None, reported, where it is wrong."""
    inner = replace(context, place=f"{context.place}/at")
    if statement.at is None:
        return _begin_of_route(checker, statement, inner, network, route)
    if isinstance(statement.at, ast.Name) and statement.at.word == "random":
        return _anywhere(checker, statement, statement.at, inner)
    if _is_misspelled_random(checker, statement.at):
        at = statement.at.span
        checker.report(Code.UNKNOWN_NAME, at, name=at.text, meant="random")
        return None
    typed = checker.infer(statement.at, inner)
    if typed.is_unknown:
        return None
    if isinstance(typed.type, KindCallType) and typed.type.verb == "position":
        return _by_another(checker, statement, typed, network)
    if isinstance(typed.type, CoordinatesType):
        return _point(checker, statement, typed, network)
    if network is not None:
        help_ = "write `at random`, a point `at (10m, 20m)`, or `route: ...` without `at`"
        checker.report(Code.NO_PLACE_IN_NETWORK, typed.span, network=network, help=help_)
        return None
    return _along_road(checker, statement, typed)


def _is_misspelled_random(checker: Checker, at: ast.Expression) -> bool:
    if not isinstance(at, ast.Name) or at.text in checker.program.declarations:
        return False
    return nearest(at.text, (*checker.program.declarations, "random")) == "random"


def _along_road(
    checker: Checker, statement: ast.Actor, typed: TypedExpression
) -> TypedExpression | None:
    if not isinstance(typed.type, Quantity):
        expected = "a length or a share of the road" if statement.on else "a point `(x, y)`"
        checker.report(
            Code.WRONG_TYPE, typed.span, what="`at`", expected=expected, found=typed.type,
            help=position_help(typed),
        )  # fmt: skip
        return None
    if statement.on is None:
        _report_no_road(checker, statement, typed.span)
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


def _begin_of_route(
    checker: Checker,
    statement: ast.Actor,
    context: Context,
    network: str | None,
    route: Value | None,
) -> TypedExpression | None:
    """The first point of a route that has several; some place in a lane, where it is random or
    begins with a turn."""
    name = statement.name
    if route is not None and _is_spoiled(checker, statement.on):
        return None  # a network could begin the route
    if network is not None and (isinstance(route, RandomValue) or begins_with_turn(route)):
        return _anywhere(checker, statement, name, context)
    if network is not None and isinstance(route, Items) and len(route.items) > 1:
        first = route.items[0]
        kind = KindCallType("position") if isinstance(first, PassCall) else CoordinatesType()
        return TypedExpression(name.span, kind, first)
    if network is not None and route is not None:
        help_ = "write `at` and where it begins, or a second point in its route"
    elif network is not None:
        help_ = "write `at random`, `at (10m, 20m)`, or a `route: [(10m, 20m), (80m, 40m)]`"
    elif statement.on is not None:
        help_ = "write `at 20m` or `at 50%` before the block"
    else:
        help_ = "write `at (40m, 32m)`, or `on ROAD at 20m`, before the block"
    checker.report(Code.MISSING_POSITION, name.span, name=name.text, help=help_)
    return None


def begins_with_turn(route: Value | None) -> bool:
    """Whether a route has items, but does not say where it begins."""
    return isinstance(route, Items) and not isinstance(route.items[0], Items | PassCall)


def _anywhere(
    checker: Checker, statement: ast.Actor, place: ast.SyntaxNode, context: Context
) -> TypedExpression | None:
    """`at random`: what `at 0%..100%` says; in a network a share of all its lanes."""
    if statement.on is None:
        _report_no_road(checker, statement, place.span)
        return None
    value = drawn_share(checker, place, context)
    if value is None:
        return None
    return TypedExpression(place.span, Quantity(PURE), value, random=True, bounds=(0.0, 1.0))


def _report_no_road(checker: Checker, statement: ast.Actor, place: Span) -> None:
    roads = [n for n, d in checker.program.declarations.items() if d.role in PLACED_ON]
    name = statement.name.text
    help_ = f"write `on {roads[0] if len(roads) == 1 else 'ROAD'}` before `at`"
    checker.report(Code.ARC_LENGTH_WITHOUT_ROAD, place, name=name, help=help_)


def drawn_share(checker: Checker, place: ast.SyntaxNode, context: Context) -> RandomValue | None:
    """A number between 0 and 1 that is drawn, or None, reported."""
    found = find_default(checker, "distribution", place.span)
    if found is None:
        return None
    name = checker.draw_place(context)
    ends: Options = FrozenDict({"low": ConstantValue(0.0), "high": ConstantValue(1.0)})
    call = PassCall("distribution", found.entry.qualified, ends, name, place.span)
    return RandomValue(name, call, context.per, PURE)


def _by_another(
    checker: Checker, statement: ast.Actor, typed: TypedExpression, network: str | None
) -> TypedExpression | None:
    """A position by another agent or object, which is on the same road, or a place in a network."""
    assert isinstance(typed.value, PassCall)
    if network is None and not is_by_another(typed.value):
        expected, found = "a length or a share of the road", "a place in a network"
        checker.report(Code.WRONG_TYPE, typed.span, what="`at`", expected=expected, found=found)
        return None
    for value in typed.value.options.values():
        if isinstance(value, Entity) and value.role in ("agent", "object"):
            other = checker.program.declarations[value.name].statement
            assert isinstance(other, ast.Actor)
            road, own_road = road_of(checker, other), road_of(checker, statement)
            if road is None or own_road is None:
                if goes_in_circles(checker, other):
                    return None
                name, member = value.name, "place on a road"
                checker.report(Code.START_WITHOUT_ROAD, typed.span, name=name, member=member)
                return None
            names = {_declared_name(road), _declared_name(own_road)}
            if not names <= checker.program.declarations.keys():
                return None  # reported where it stands
            if len(names) > 1:
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


def _declared_name(road: ast.Expression) -> str:
    """Of the road in the program, which is not as it is written in files that are included."""
    return road.text if isinstance(road, ast.Name) else road.span.text


def is_by_another(call: PassCall) -> bool:
    """Whether a position is by another agent or object."""
    named = (value for value in call.options.values() if isinstance(value, Entity))
    return any(value.role in ("agent", "object") for value in named)


def _is_spoiled(checker: Checker, road: ast.Expression | None) -> bool:
    """Whether its declaration has a mistake, so that it may be a road or a network."""
    return isinstance(road, ast.Name) and road.text in checker.program.spoiled


def _point(
    checker: Checker, statement: ast.Actor, typed: TypedExpression, network: str | None
) -> TypedExpression | None:
    from ...plugins.option_types import PointType as PointOption
    from ...plugins.options import Constraints
    from ..types.assignable import check_assignable

    if statement.on is not None and network is None:
        if _is_spoiled(checker, statement.on):
            return None  # who knows what it is
        road = statement.on.span.text
        help_ = f"write a length, such as `at 20m`, or leave `on {road}` out"
        checker.report(Code.POINT_ON_ROAD, typed.span, name=statement.name.text, help=help_)
        return None
    schema = OptionSchema("at", PointOption(LENGTH), None, Constraints())
    return check_assignable(checker, typed, schema)
