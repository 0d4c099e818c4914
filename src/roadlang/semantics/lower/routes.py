"""The routes of agents through networks: points to pass and turns to take, or a draw that decides
turn by turn."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from ...diagnostics import Code
from ...ir.read_only import FrozenDict
from ...ir.values import Items, Options, PassCall, RandomValue, TextValue, Value
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.inherited_roads import named_in_position
from .actor_places import begins_with_turn, drawn_share, is_by_another
from .references import resolved

_NO_LANE = TextValue("none")
_RANDOM = TextValue("random")


def with_route(
    checker: Checker,
    statement: ast.Actor,
    context: Context,
    network: str | None,
    options: Options,
    drives: bool,
) -> Options | None:
    """The options with the route as a list of points and turns, or as a draw; None, reported, where
    it cannot be. What drives in a network has a random route where the file says none."""
    written = {option.key.text: option for option in _written(statement)}
    key = next((name for name in ("route", "route_length") if name in options), None)
    if key is not None and network is None:
        _report_without_network(checker, statement, written[key])
        return None
    clash = "lane" if options.get("lane") == _NO_LANE else None
    clash = "side" if clash is None and "side" in options and "lane" not in options else clash
    if clash is not None and key is not None:
        checker.report(
            Code.ROUTE_DISAGREES, written[key].span, name=statement.name.text,
            option=f"`{written[clash].span.text}`", help="a route leads along lanes",
        )  # fmt: skip
        return None
    route = resolved(checker, options.get("route"))
    follows = named_in_position(checker, statement) is not None
    if route is None and not (drives and network is not None and clash is None and not follows):
        return options
    if route is not None and route != _RANDOM:
        items = _stages(checker, statement, route, written, "route_length" in options)
        return None if items is None else FrozenDict({**options, "route": items})
    place = written["route"].value if "route" in written else statement.name
    drawn = drawn_share(checker, place, replace(context, place=f"{context.place}/route"))
    return None if drawn is None else FrozenDict({**options, "route": drawn})


def _stages(
    checker: Checker,
    statement: ast.Actor,
    route: Value,
    written: Mapping[str, ast.Option],
    has_length: bool,
) -> Items | None:
    """The points, places and turns of a route that is not random as a whole."""
    items, span = route.items if isinstance(route, Items) else (route,), written["route"].value.span
    if any(_may_be_random(checker, item) for item in items):
        checker.report(
            Code.WRONG_TYPE, span, what="each item of `route`",
            expected="a point, a place in the network, or a turn", found="`random`",
            help="`random` stands alone: `route: random`",
        )  # fmt: skip
        return None
    if any(isinstance(item, PassCall) and is_by_another(item) for item in items):
        expected, found = "points, or places in the network", "a position by another"
        checker.report(Code.WRONG_TYPE, span, what="`route`", expected=expected, found=found)
        return None
    if has_length:
        checker.report(
            Code.ROUTE_DISAGREES, written["route_length"].span, name=statement.name.text,
            option="`route_length`", help="it is for `route: random`",
        )  # fmt: skip
        return None
    return Items(items)


def rest_of_route(options: Options) -> Options:
    """Without the first point, where the agent begins."""
    route = options["route"]
    if not isinstance(route, Items) or begins_with_turn(route):
        return options
    return FrozenDict({**options, "route": Items(route.items[1:])})


def _may_be_random(checker: Checker, item: Value) -> bool:
    """Whether an item of a list is the word that stands for a whole route."""
    item = resolved(checker, item) or item
    if isinstance(item, RandomValue):
        return any(_may_be_random(checker, part) for part in item.call.options.values())
    if isinstance(item, Items):
        return any(_may_be_random(checker, part) for part in item.items)
    return item == _RANDOM


def _report_without_network(checker: Checker, statement: ast.Actor, option: ast.Option) -> None:
    on = statement.on
    name, road = statement.name.text, "no road" if on is None else f"`{on.span.text}`"
    declared = checker.program.declarations.get(on.span.text) if on is not None else None
    source = getattr(declared.statement, "source", None) if declared is not None else None
    network = source.span.text if isinstance(source, ast.Name) else "town"
    help_ = f"a route leads through the roads of a network: `is ... on {network}`"
    checker.report(Code.ROUTE_WITHOUT_NETWORK, option.span, name=name, road=road, help=help_)


def _written(statement: ast.Actor) -> tuple[ast.Option, ...]:
    return statement.block.options if statement.block is not None else ()
