"""The routes of agents through networks: points to pass, or a draw that decides turn by turn."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code
from ...ir.read_only import FrozenDict
from ...ir.values import Items, Options, PassCall, TextValue
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.inherited_roads import named_in_position
from .actor_places import drawn_share, is_by_another
from .references import resolved

_NO_LANE = TextValue("none")


def with_route(
    checker: Checker,
    statement: ast.Actor,
    context: Context,
    network: str | None,
    options: Options,
    drives: bool,
) -> Options | None:
    """The options with the route as points or as a draw; None, reported, where it cannot be. What
    drives in a network has a random route where the file says none."""
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
    if isinstance(route, Items):
        if any(isinstance(item, PassCall) and is_by_another(item) for item in route.items):
            expected, found = "points, or places in the network", "a position by another"
            span = written["route"].value.span
            checker.report(Code.WRONG_TYPE, span, what="`route`", expected=expected, found=found)
            return None
        if "route_length" in options:
            checker.report(
                Code.ROUTE_DISAGREES, written["route_length"].span, name=statement.name.text,
                option="`route_length`", help="it is for `route: random`; points say how far",
            )  # fmt: skip
            return None
        return FrozenDict({**options, "route": route})
    place = written["route"].value if "route" in written else statement.name
    drawn = drawn_share(checker, place, replace(context, place=f"{context.place}/route"))
    return None if drawn is None else FrozenDict({**options, "route": drawn})


def rest_of_route(options: Options) -> Options:
    """Without the first point, where the agent begins."""
    route = options["route"]
    return (
        FrozenDict({**options, "route": Items(route.items[1:])})
        if isinstance(route, Items)
        else options
    )


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
