"""Agents and objects: what they are, where they stand, who drives."""

from __future__ import annotations

from dataclasses import replace

from ...diagnostics import Code
from ...ir import scenario as ir
from ...ir.category import ON_FOOT
from ...ir.read_only import FrozenDict
from ...ir.values import NO_OPTIONS, Entity, Options, PassCall, Reference, Value
from ...plugins.kinds import AgentKind, Controller
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.actor_kinds import calls_in, shared_options, with_options
from ..infer.blocks import lower_options, lower_passes, value_spans
from ..infer.habits import chosen_road_help
from ..infer.inherited_roads import road_of
from ..infer.option_binding import divided
from ..infer.statement_spec import StatementSpec
from ..names.program import Declaration
from ..types.expression_types import DeclaredType, KindCallType, Quantity, TypedExpression
from .actor_places import PLACED_ON, place_of
from .routes import rest_of_route, with_route
from .sensors import sensors_of


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
    network = on if isinstance(on, str) and _is_network(checker, on) else None
    placement, kind_options = _options(checker, statement, spec, kind, context)
    passes = lower_passes(checker, spec, statement.block, context)
    drive = tuple(call for call in passes or () if call.verb == "drive")
    if on is not False and placement is not None:
        placement = with_route(checker, statement, context, network, placement, bool(drive))
    route = None if placement is None else placement.get("route")
    unknown_route = placement is None and statement.at is None
    at = None if unknown_route else place_of(checker, statement, context, network, route)
    if statement.block is not None and not statement.block.complete:
        return None
    if kind is None or kind.value is None or on is False or at is None or at.value is None:
        return None
    if placement is None or passes is None:
        return None
    sensors = sensors_of(checker, statement, passes)
    _warn_without_base(checker, name, drive)
    _warn_on_foot(checker, name, kind.value, drive)
    if on is None and not _fits_without_road(checker, statement):
        return None
    if statement.at is None and route is not None:
        placement = rest_of_route(placement)
    value = with_options(checker, kind.value, kind_options)
    fraction = isinstance(at.type, Quantity) and at.type.dimension.is_pure and not at.type.fits_any
    road = on if isinstance(on, str) else None
    spans = value_spans(statement.block)
    if statement.at is not None:
        spans = FrozenDict({**spans, "at": statement.at.span})
    return ir.ScenarioActor(
        name, value, road, at.value, fraction, placement, drive, sensors, statement.span, spans
    )


def _warn_without_base(checker: Checker, name: str, drive: tuple[PassCall, ...]) -> None:
    """RL293 where the first controller leaves something to one before it."""
    if not drive:
        return
    kind, span = checker.registry.find("drive", drive[0].kind).load(), drive[0].span
    if span is not None and issubclass(kind, Controller) and kind.leaves_open:
        checker.report(
            Code.NO_BASE_CONTROLLER, span, kind=kind.name, name=name, rest=kind.leaves_open,
            help="write `drive with traffic` before it; with the same `when`, if the agent is to "
            "stand until then",
        )  # fmt: skip


def _warn_on_foot(checker: Checker, name: str, kind: Value, drive: tuple[PassCall, ...]) -> None:
    """RL294 where an agent that is always on foot is driven as vehicles are."""
    if not drive:
        return
    kinds = [checker.registry.find("agent", call.kind).load() for call in calls_in(kind)]
    if not kinds or not all(issubclass(k, AgentKind) and k.category in ON_FOOT for k in kinds):
        return
    for call in drive:
        controller = checker.registry.find("drive", call.kind).load()
        if issubclass(controller, Controller) and controller.for_vehicles and call.span is not None:
            checker.report(
                Code.DRIVEN_ON_FOOT, call.span, name=name, kind=kinds[0].name,
                controller=controller.name,
                help="write `drive with walk`, or `drive with crossing` for one who crosses the "
                "road",
            )  # fmt: skip


def _is_network(checker: Checker, name: str) -> bool:
    return checker.program.declarations[name].role == "network"


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
    typed = checker.infer(named, replace(context, roles=PLACED_ON))
    if typed.is_unknown:
        return False
    if isinstance(typed.type, DeclaredType) and typed.type.role in PLACED_ON:
        assert isinstance(typed.value, Entity)
        return typed.value.name
    what, found = "`on`", typed.type
    if isinstance(typed.type, DeclaredType):
        checker.report(
            Code.WRONG_ENTITY_TYPE,
            typed.span,
            name=typed.span.text,
            found=found,
            expected="a road or network",
            what=what,
        )
    else:
        checker.report(
            Code.WRONG_TYPE, typed.span, what=what, expected="a road or network", found=found,
            help=chosen_road_help(typed),
        )  # fmt: skip
    return False


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
    bound = lower_options(checker, spec, block, context, statement.name.span, extra)
    if "spacing" in bound.stated and not _has_count(statement):
        span = bound.stated["spacing"].span
        help_ = "say how many there are: `count: 5`"
        checker.report(Code.SPACING_WITHOUT_COUNT, span, name=statement.name.text, help=help_)
        return None, NO_OPTIONS
    lane = bound.stated.get("lane")
    if "side" in bound.stated and lane is not None and isinstance(lane.type, Quantity):
        help_ = "the number gives the side: negative to the right of the center line, positive left"
        checker.report(Code.LANE_AND_SIDE, bound.stated["side"].span, help=help_)
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
