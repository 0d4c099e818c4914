"""Patches of surfaces that are on no lane, road or interval, as far as no draw has a say."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from ..diagnostics import Diagnostic, Span
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.lanes.lanes import DEFAULT_LANES
from ..ir.scenario import ScenarioNetwork, ScenarioRoad
from ..ir.values import ConstantValue, Entries, Items, Options, Value
from ..world.lanes.lane_plan import LanePlan, known_ids, lane_plan
from ..world.surface_faults import PATCHES, patch_span, unknown_patch_lane, unknown_patch_road
from .fixed_positions import drawer_of, interval_fault

_Patch = tuple[Options, Span | None]


def surface_faults(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL411, RL414 and RL613 for patches that no scene has a place for.

    Which roads a network has is not known here: see `unknown_roads`.
    """
    said: set[Diagnostic] = set()  # what is made from a road has its patches
    for road in scenario.roads.values():
        for patch, span in _patches(road, scenario):
            for fault in _faults(patch, span, road, scenario):
                if replace(fault, message="") not in said:
                    said.add(replace(fault, message=""))
                    yield fault
    for network in scenario.networks.values():
        for patch, span in _patches(network, scenario):
            yield from interval_fault(patch.get("over"), span, network, scenario)
            if "road" not in patch:
                yield from _lane_fault(patch, span, network, scenario)


def names_roads(network: ScenarioNetwork, scenario: IndexedScenario) -> bool:
    """Whether a patch of a network is on a certain road."""
    return any(
        _constant(patch.get("road"), scenario) is not None
        for patch, _ in _patches(network, scenario)
    )


def unknown_roads(
    network: ScenarioNetwork, ids: Sequence[int], scenario: IndexedScenario
) -> Iterator[Diagnostic]:
    """RL411 for patches on roads that a network does not have; `ids` of those that it has."""
    for patch, span in _patches(network, scenario):
        road = _constant(patch.get("road"), scenario)
        fault = None if road is None else unknown_patch_road(span, road, ids)
        if fault is not None:
            yield fault


def road_lane_plan(road: ScenarioRoad, scenario: IndexedScenario) -> LanePlan:
    """What is written about the lanes of a road; of one that is drawn, at least how many."""
    plan = lane_plan(road, scenario)
    if plan.owner is None and drawer_of(road, scenario) is not None:
        return replace(plan, owner=road, lanes=ConstantValue(DEFAULT_LANES))
    return plan


def _patches(source: ScenarioRoad | ScenarioNetwork, scenario: IndexedScenario) -> Iterator[_Patch]:
    """The patches of a road or network, written there or in what it is made from."""
    alike = (link for link in scenario.chain(source) if type(link) is type(source))
    for link in alike:
        if PATCHES in link.options:
            assert isinstance(link, ScenarioRoad | ScenarioNetwork)
            listed = scenario.resolved(link.options[PATCHES])
            items = listed.items if isinstance(listed, Items) else ()
            for place, item in enumerate(items):
                written = scenario.resolved(item)
                if isinstance(written, Entries):
                    yield written.entries, patch_span(link, place)
            return


def _faults(
    patch: Options, span: Span | None, road: ScenarioRoad, scenario: IndexedScenario
) -> Iterator[Diagnostic]:
    number = _constant(patch.get("road"), scenario)
    fault = None if number is None else unknown_patch_road(span, number, ())
    if fault is not None:
        yield fault
        return
    yield from interval_fault(patch.get("over"), span, road, scenario)
    yield from _lane_fault(patch, span, road, scenario)


def _lane_fault(
    patch: Options,
    span: Span | None,
    source: ScenarioRoad | ScenarioNetwork,
    scenario: IndexedScenario,
) -> Iterator[Diagnostic]:
    lane = _constant(patch.get("lane"), scenario)
    if isinstance(source, ScenarioRoad):
        ids = known_ids(road_lane_plan(source, scenario), scenario)
    else:
        ids = known_ids(lane_plan(source, scenario), scenario)
    fault = (
        None if lane is None or ids is None else unknown_patch_lane(span, source.name, lane, ids)
    )
    if fault is not None:
        yield fault


def _constant(value: Value | None, scenario: IndexedScenario) -> int | None:
    if value is None:
        return None
    low, high = scenario.value_bounds.of(value)
    return round(low) if low == high else None
