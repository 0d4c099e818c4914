"""Roads and networks that are the same in every scene and cost little, made before anything is
drawn: what their files hold, whether they close, and whether ids that name parts of them exist."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from functools import partial

from ..diagnostics import Code, Diagnostic, DiagnosticError
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import FileSource, ScenarioImage, ScenarioNetwork, ScenarioRoad, TextSource
from ..ir.values import Flag, PassCall
from .fixed_surfaces import names_roads, unknown_roads

_LARGEST_FILE = 1_000_000
"""Bytes of a map or table that is read, about a second's worth; `compile` reads larger ones."""

_IDS = (Code.UNKNOWN_JUNCTION_ID, Code.UNKNOWN_ROAD_ID, Code.ROAD_NOT_AT_JUNCTION)


def fixed_roads(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """What is wrong with roads that are read from tables or drawn with `closed: true`, and with the
    ids by which passes and roads name parts of a map or typed picture.

    Only where there is such a road is numpy imported; a map is read only where ids name its parts.
    """
    for road in scenario.roads.values():
        if _is_made(road, scenario):
            yield from _raised(partial(_make, [road], scenario))
    for network in scenario.networks.values():
        if _is_cheap(network, scenario):
            named = [call for call in network.passes if _names_parts(call, scenario)]
            chosen = [road for road in scenario.roads.values() if _selects(road, network, scenario)]
            if names_roads(network, scenario):
                yield from _raised(partial(_patched_roads, network, scenario))
            if named:
                yield from _raised(partial(_look_up, network, named, scenario))
            if chosen:
                yield from _raised(partial(_make, chosen, scenario))


def _raised(make: Callable[[], None]) -> tuple[Diagnostic, ...]:
    try:
        make()
    except DiagnosticError as error:
        return error.diagnostics
    return ()


def _is_made(road: ScenarioRoad, scenario: IndexedScenario) -> bool:
    if scenario.is_varying(road.name):
        return False
    if isinstance(road.source, FileSource):
        return _is_small(road.source)
    is_drawn = road.source is None and any(call.verb == "draw" for call in road.passes)
    return is_drawn and road.options.get("closed") == Flag(True)


def _is_small(source: FileSource) -> bool:
    try:
        return os.path.getsize(source.resolved) <= _LARGEST_FILE
    except OSError:
        return True  # what is wrong with it is said as it is read


def _is_cheap(network: ScenarioNetwork, scenario: IndexedScenario) -> bool:
    """Whether it comes from a small map or a typed picture, which no draw changes."""
    if scenario.is_varying(network.name):
        return False
    bottom = list(scenario.chain(network))[-1]
    if isinstance(bottom.source, FileSource):
        return isinstance(bottom, ScenarioNetwork) and _is_small(bottom.source)
    return isinstance(bottom, ScenarioImage) and isinstance(bottom.source, TextSource)


def _names_parts(call: PassCall, scenario: IndexedScenario) -> bool:
    if call.verb == "control":
        return "junctions" in call.common or "roads" in call.options
    roads = call.common.get("roads")
    return roads is not None and not scenario.dependencies.draws(roads)


def _selects(road: ScenarioRoad, network: ScenarioNetwork, scenario: IndexedScenario) -> bool:
    """Whether a road is a certain part of the network, with nothing drawn about which."""
    called = isinstance(scenario.resolved(road.options.get("select")), PassCall)
    return called and scenario.source_of(road) is network and not scenario.is_varying(road.name)


def _make(roads: list[ScenarioRoad], scenario: IndexedScenario) -> None:
    from ..evaluate.candidates import fixed_candidate
    from ..world.index import index_scenario
    from ..world.roads.roads import road_root

    candidate = fixed_candidate(index_scenario(scenario.source, scenario.registry))
    for road in roads:
        road_root(road.name, candidate)


def _patched_roads(network: ScenarioNetwork, scenario: IndexedScenario) -> None:
    from ..evaluate.candidates import fixed_candidate
    from ..world.index import index_scenario
    from ..world.networks.networks import network_root

    candidate = fixed_candidate(index_scenario(scenario.source, scenario.registry))
    ids = [edge.id for edge in network_root(network, candidate).edges]
    found = tuple(unknown_roads(network, ids, scenario))
    if found:
        raise DiagnosticError(*found)


def _look_up(network: ScenarioNetwork, calls: list[PassCall], scenario: IndexedScenario) -> None:
    from ..evaluate.candidates import fixed_candidate
    from ..world.index import index_scenario
    from ..world.networks.junction_control import right_of_way_rules
    from ..world.networks.networks import chosen_edges, network_root

    candidate = fixed_candidate(index_scenario(scenario.source, scenario.registry))
    root = network_root(network, candidate)
    for call in calls:
        if call.verb != "control":
            chosen_edges(call, root.network, candidate)
    if any(call.verb == "control" for call in calls):
        try:
            right_of_way_rules(network, candidate)
        except DiagnosticError as error:
            found = [fault for fault in error.diagnostics if fault.code in _IDS]
            if found:  # a rule may refuse what is drawn
                raise DiagnosticError(*found) from error
