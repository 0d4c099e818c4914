"""Faults that every scene would have: `check` finds them before anything is sampled.

What the scenario alone decides is found without numpy. Only where a position may be beyond the end
of a road is the road drawn.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..files.reading import UnreadableFile, read_file, read_start
from ..geometry.lanes import DEFAULT_LANES
from ..images.image_header import read_header
from ..images.image_scale import scale_in_file
from ..ir.scenario import (
    FileSource,
    Scenario,
    ScenarioActor,
    ScenarioImage,
    ScenarioNetwork,
    ScenarioRoad,
)
from ..ir.values import ConstantValue, Flag, PassCall, TextValue
from ..plugins.guard import plugin_guard
from ..plugins.kinds import Drawer
from ..plugins.registry import Registry
from ..plugins.stated_bounds import OptionRange
from ..world.interval_faults import interval_off_road
from ..world.lane_plan import known_ids, lane_plan
from ..world.placement_faults import missing_scale, unknown_lane
from .constant_kinds import constant_kind
from .fixed_draws import refused_draws
from .fixed_junctions import fixed_junctions
from .fixed_overlaps import fixed_overlaps
from .unsupported import unsupported_parts

_ROUNDING = 1e-9


def fixed_faults(source: Scenario, registry: Registry) -> list[Diagnostic]:
    """Distributions with wrong options, images without scale, intervals without length, lanes that
    are not there, positions beyond their roads, things in one place, junctions that are not there,
    and what backends and the simulator do not support.

    Roads from picture files are not checked: they are read when scenes are made.
    """
    scenario = IndexedScenario(source, registry, _nothing_measured)
    found = [
        *refused_draws(scenario),
        *_missing_scales(scenario),
        *_intervals_without_length(scenario),
    ]
    for actor in (*source.agents, *source.objects):
        if actor.on in scenario.roads:
            fault = _lane_fault(actor, scenario) or _position_fault(actor, scenario)
            found += [fault] if fault is not None else []
    found += [*fixed_overlaps(scenario), *fixed_junctions(scenario)]
    return [*found, *unsupported_parts(scenario)]


def _nothing_measured(call: PassCall, candidates: Any, element: int) -> Any:
    raise NotImplementedError


def _missing_scales(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    for network in scenario.networks.values():
        image = scenario.source_of(network)
        if isinstance(image, ScenarioImage) and not _has_scale(image, scenario):
            yield missing_scale(image)


def _intervals_without_length(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL414 for `over: [50m, 50m]`."""
    sources: list[ScenarioRoad | ScenarioNetwork] = list(scenario.roads.values())
    for source in [*sources, *scenario.networks.values()]:
        for call in source.passes:
            over = call.common.get("over")
            interval = scenario.value_bounds.option(over) if call.verb == "perturb" else None
            if isinstance(interval, OptionRange) or not isinstance(interval, tuple):
                continue
            ends = {end for part in interval for end in (part.low, part.high)}
            if len(ends) == 1:
                yield interval_off_road(call, source.name, *(2 * [ends.pop()]))


def _has_scale(image: ScenarioImage, scenario: IndexedScenario) -> bool:
    chain = [link for link in scenario.chain(image) if isinstance(link, ScenarioImage)]
    if any("scale" in link.options for link in chain):
        return True
    root = chain[-1]
    has_reader = any(call.verb == "read" for call in root.passes)
    return isinstance(root.source, FileSource) and not has_reader and _file_has_scale(root.source)


def _file_has_scale(source: FileSource) -> bool:
    path = Path(source.resolved)
    try:
        start = read_start(path, 64)
        is_tiff = start[:4] in (b"II*\x00", b"MM\x00*")
        content = read_file(path) if is_tiff else start
    except UnreadableFile:
        return True  # what is wrong with the file is said where it is read
    header = read_header(content) if is_tiff else None
    return scale_in_file(path, content, header.format if header else "") is not None


def _lane_fault(actor: ScenarioActor, scenario: IndexedScenario) -> Diagnostic | None:
    lane = actor.options.get("lane")
    lanes = _lane_ids(actor, scenario)
    if lane is None or lanes is None or isinstance(lane, TextValue | PassCall):
        return None
    low, high = scenario.value_bounds.of(lane)
    return unknown_lane(actor, round(low), lanes) if low == high else None


def _lane_ids(actor: ScenarioActor, scenario: IndexedScenario) -> tuple[int, ...] | None:
    """The lanes of the road of an agent or object; None where they are not known yet."""
    plan = lane_plan(scenario.roads[str(actor.on)], scenario)
    if plan.owner is None and _drawer(actor, scenario) is not None:
        plan = replace(
            plan, owner=scenario.roads[str(actor.on)], lanes=ConstantValue(DEFAULT_LANES)
        )
    return known_ids(plan, scenario)


def _position_fault(actor: ScenarioActor, scenario: IndexedScenario) -> Diagnostic | None:
    call = _drawer(actor, scenario)
    if call is None or _may_be_closed(actor, scenario):
        return None
    low, high = scenario.value_bounds.of(actor.at)
    if actor.at_fraction:
        off = low > 1 + _ROUNDING or high < -_ROUNDING
        return _off_road(actor, f"{100 * (low if low > 1 else high):g}%") if off else None
    if high < -_ROUNDING:
        return _off_road(actor, f"{high:g}m")
    is_perturbed = any(c.verb == "perturb" for r in _roads(actor, scenario) for c in r.passes)
    if is_perturbed or low <= _least_length(call, scenario):
        return None
    length = _length(actor, scenario)
    if length is None or low <= length * (1 + _ROUNDING):
        return None
    return _off_road(actor, f"{low:g}m", f"`{actor.on}` is {length:.6g}m long")


def _off_road(actor: ScenarioActor, position: str, help_: str = "") -> Diagnostic:
    return diagnose(
        Code.POSITION_OFF_ROAD,
        actor.span_of("at"),
        name=actor.name,
        position=position,
        road=actor.on,
        help=help_ or "positions count from the start of the road, 0m or 0%, to its end, 100%",
    )


def _roads(actor: ScenarioActor, scenario: IndexedScenario) -> Iterator[ScenarioRoad]:
    """The road of an agent or object, the one that it is made from, and so on."""
    road = scenario.roads[str(actor.on)]
    return (link for link in scenario.chain(road) if isinstance(link, ScenarioRoad))


def _drawer(actor: ScenarioActor, scenario: IndexedScenario) -> PassCall | None:
    """The `draw with` that the road goes back to; None where it comes from a file or network."""
    bottom = list(_roads(actor, scenario))[-1]
    drawn = [call for call in bottom.passes if call.verb == "draw"]
    return drawn[0] if drawn and bottom.source is None else None


def _may_be_closed(actor: ScenarioActor, scenario: IndexedScenario) -> bool:
    values = [road.options.get("closed") for road in _roads(actor, scenario)]
    return any(value not in (None, Flag(False)) for value in values)


def _least_length(call: PassCall, scenario: IndexedScenario) -> float:
    """What the drawer says; 0 where its options are drawn, or it says nothing."""
    built = constant_kind(call, scenario)
    if not isinstance(built, Drawer):
        return 0.0
    with plugin_guard(scenario.kind(call)[0], call.span):
        return float(built.least_length())


def _length(actor: ScenarioActor, scenario: IndexedScenario) -> float | None:
    """Meters; None where it differs between scenes, or is not known."""
    if any(scenario.is_varying(road.name) for road in _roads(actor, scenario)):
        return None
    from ..evaluate.candidates import fixed_candidate
    from ..world.index import index_scenario
    from ..world.roads import road_batch

    indexed = index_scenario(scenario.source, scenario.registry)
    try:
        batch = road_batch(str(actor.on), fixed_candidate(indexed))
    except DiagnosticError:
        return None  # what is wrong with the road is said where it is made
    return float(batch.length[0, 0])
