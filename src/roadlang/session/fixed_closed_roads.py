"""Formulas that cannot be evaluated as their road is closed in every scene."""

from __future__ import annotations

from collections.abc import Iterator

from ..diagnostics import Diagnostic
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioRoad
from ..ir.values import Condition, Flag
from ..world.roads.closed_road_faults import closed_road_fault


def fixed_closed_roads(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL312 for formulas over roads that are `closed: true` or made from such a road."""
    source = scenario.source
    for constraint in (*source.requirements, *source.expectations):
        condition = constraint.test
        if isinstance(condition, Condition) and _is_on_closed_road(condition, scenario):
            fault = closed_road_fault(condition)
            if fault is not None:
                yield fault


def _is_on_closed_road(condition: Condition, scenario: IndexedScenario) -> bool:
    """Whether its positions are those of a closed road; roads in one formula have the same root."""
    if condition.domain != "road":
        return False
    roads = [e.name for e in scenario.dependencies.entities(condition) if e.role == "road"]
    return any(_is_closed(scenario.roads[name], scenario) for name in roads)


def _is_closed(road: ScenarioRoad, scenario: IndexedScenario) -> bool:
    root = list(scenario.chain(road))[-1]
    return isinstance(root, ScenarioRoad) and root.options.get("closed") == Flag(True)
