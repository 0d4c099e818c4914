"""Lanes that are counted from the lane of another agent or object."""

from __future__ import annotations

import numpy as np

from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry.arrays import Integers
from ...ir.scenario import ScenarioActor
from ...ir.values import Measure, Value
from ..lanes.lane_plan import is_fixed as has_fixed_lanes
from ..lanes.lane_plan import lane_plan
from .actor_numbers import column
from .copies import element_of


def may_be_missing(actor: ScenarioActor, scenario: IndexedScenario) -> bool:
    """Whether another decides the lane of an agent or object, as with `at beside(ego, left)` or
    `lane: ego.start_lane + 1`, and draws decide that of the other: where the road has no such lane,
    other draws may have one. A lane that is the same in every scene is there or is a mistake."""
    return bool(_deciding(actor, scenario)) and not _is_fixed(actor, scenario)


def _is_fixed(actor: ScenarioActor, scenario: IndexedScenario) -> bool:
    """Whether its lane is the same in every scene, and so are the lanes of its road."""
    road = scenario.roads.get(str(actor.on))
    options = [actor.options[name] for name in ("lane", "side", "facing") if name in actor.options]
    if road is None or scenario.dependencies.draws(*options):
        return False
    if not has_fixed_lanes(lane_plan(road, scenario), scenario):
        return False
    return all(_is_fixed(other, scenario) for other in _deciding(actor, scenario))


def _deciding(actor: ScenarioActor, scenario: IndexedScenario) -> list[ScenarioActor]:
    """The agents and objects that its lane is counted from."""
    values = _measured(actor, scenario) if "lane" in actor.options else [actor.at]
    names = {entity.name for entity in scenario.dependencies.entities(*values)}
    return [scenario.actors[name] for name in sorted(names & scenario.actors.keys())]


def over_the_middle(actor: ScenarioActor, copies: CopyBatch, lane: Integers) -> Integers:
    """(R,) lanes counted from that of another (`ego.start_lane + 1`), which go on over the middle,
    which has no number."""
    measured = _measured(actor, copies.scenario)
    if len(measured) != 1:
        return lane
    base = column(evaluate(measured[0], copies, element_of(actor)), copies)
    lane = np.where((base < 0) & (lane >= 0), lane + 1, lane)
    return np.where((base > 0) & (lane <= 0), lane - 1, lane)


def _measured(actor: ScenarioActor, scenario: IndexedScenario) -> list[Value]:
    """What of a scene the lane is counted from, also by the name of a `let`."""
    inside = scenario.dependencies.contents(actor.options.get("lane"))
    return [value for value in inside if isinstance(value, Measure)]
