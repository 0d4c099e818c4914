"""Positions and intervals beyond the ends of their roads, as far as no draw has a say.

Only where one may be beyond the end of a road is the road drawn, with numpy.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioActor, ScenarioNetwork, ScenarioRoad
from ..ir.values import Flag, PassCall, Value
from ..plugins.guard import plugin_guard
from ..plugins.kinds import Drawer
from ..plugins.stated_bounds import OptionRange
from ..world.perturbing.interval_faults import interval_off_road
from .constant_kinds import constant_kind

_ROUNDING = 1e-9


def position_fault(actor: ScenarioActor, scenario: IndexedScenario) -> Diagnostic | None:
    """RL615 for an agent or object that begins beyond its road."""
    road = scenario.roads[str(actor.on)]
    if drawer_of(road, scenario) is None or _may_be_closed(road, scenario):
        return None
    low, high = scenario.value_bounds.of(actor.at)
    if actor.at_fraction:
        off = low > 1 + _ROUNDING or high < -_ROUNDING
        return _off_road(actor, f"{100 * (low if low > 1 else high):g}%") if off else None
    if high < -_ROUNDING:
        return _off_road(actor, f"{high:g}m")
    if any(call.verb == "perturb" for link in scenario.roads_below(road) for call in link.passes):
        return None
    length = _length_if_beyond(road, low, scenario)
    if length is None or low <= length * (1 + _ROUNDING):
        return None
    return _off_road(actor, f"{low:g}m", f"`{actor.on}` is {length:.6g}m long")


def intervals_off_road(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL414 for `over: [50m, 50m]`, and for an interval beyond the end of a road."""
    sources: list[ScenarioRoad | ScenarioNetwork] = list(scenario.roads.values())
    for source in [*sources, *scenario.networks.values()]:
        for call in source.passes:
            over = call.common.get("over") if call.verb == "perturb" else None
            span = call.option_spans.get("over", call.span)
            yield from interval_fault(over, span, source, scenario)


def interval_fault(
    over: Value | None,
    span: Span | None,
    source: ScenarioRoad | ScenarioNetwork,
    scenario: IndexedScenario,
) -> Iterator[Diagnostic]:
    """RL414 for an interval that is on no road, whatever is drawn."""
    interval = None if over is None else scenario.value_bounds.option(over)
    if not isinstance(interval, tuple) or isinstance(interval, OptionRange):
        return
    low, high = interval
    if low.low == low.high == high.low == high.high:
        yield interval_off_road(span, source.name, low.low, low.low)
    elif isinstance(source, ScenarioRoad):
        length = None
        if drawer_of(source, scenario) is not None and not _may_be_closed(source, scenario):
            length = _length_if_beyond(source, low.low, scenario)
        if length is not None and low.low >= length:
            yield interval_off_road(span, source.name, low.low, high.low, length)


def _off_road(actor: ScenarioActor, position: str, help_: str = "") -> Diagnostic:
    return diagnose(
        Code.POSITION_OFF_ROAD,
        actor.span_of("at"),
        name=actor.name,
        position=position,
        road=actor.on,
        help=help_ or "positions count from the start of the road, 0m or 0%, to its end, 100%",
    )


def drawer_of(road: ScenarioRoad, scenario: IndexedScenario) -> PassCall | None:
    """The `draw with` that a road goes back to; None where it comes from a file or network."""
    bottom = list(scenario.roads_below(road))[-1]
    drawn = [call for call in bottom.passes if call.verb == "draw"]
    return drawn[0] if drawn and bottom.source is None else None


def _may_be_closed(road: ScenarioRoad, scenario: IndexedScenario) -> bool:
    values = [link.options.get("closed") for link in scenario.roads_below(road)]
    return any(value not in (None, Flag(False)) for value in values)


def _length_if_beyond(road: ScenarioRoad, place: float, scenario: IndexedScenario) -> float | None:
    """Meters of a drawn road before it is perturbed, where a place may be beyond its end; None
    elsewhere, and where the length is not known."""
    call = drawer_of(road, scenario)
    if call is None or place <= _least_length(call, scenario):
        return None
    return _length(list(scenario.roads_below(road))[-1], scenario)


def _least_length(call: PassCall, scenario: IndexedScenario) -> float:
    """What the drawer says; 0 where its options are drawn, or it says nothing."""
    built = constant_kind(call, scenario)
    if not isinstance(built, Drawer):
        return 0.0
    with plugin_guard(scenario.kind(call)[0], call.span):
        return float(built.least_length())


def _length(road: ScenarioRoad, scenario: IndexedScenario) -> float | None:
    """Meters; None where it differs between scenes, or is not known."""
    if scenario.is_varying(road.name):
        return None
    from ..evaluate.candidates import fixed_candidate
    from ..world.index import index_scenario
    from ..world.roads.roads import road_root

    indexed = index_scenario(scenario.source, scenario.registry)
    try:
        return float(road_root(road.name, fixed_candidate(indexed)).frame.curve.length)
    except DiagnosticError:
        return None  # what is wrong with the road is said where it is made
