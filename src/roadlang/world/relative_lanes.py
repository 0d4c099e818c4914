"""Lanes that are counted from the lane of another agent or object."""

from __future__ import annotations

import numpy as np

from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import evaluate
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Integers
from ..ir.scenario import ScenarioActor
from ..ir.values import Measure, PassCall
from .copies import element_of
from .positions import column


def is_by_another(actor: ScenarioActor, scenario: IndexedScenario) -> bool:
    """Whether the lane that another is in decides the lane of an agent or object, as with
    `at beside(ego, left)` or `lane: ego.start_lane + 1`. Where the road has no such lane, other
    draws may still have one; a lane that the file itself names is there or is a mistake."""
    if "lane" not in actor.options:
        return isinstance(actor.at, PassCall)
    return bool(_measured(actor, scenario))


def over_the_middle(actor: ScenarioActor, copies: CopyBatch, lane: Integers) -> Integers:
    """(R,) lanes counted from that of another (`ego.start_lane + 1`), which go on over the middle,
    which has no number."""
    measured = _measured(actor, copies.scenario)
    if len(measured) != 1:
        return lane
    base = column(evaluate(measured[0], copies, element_of(actor)), copies)
    lane = np.where((base < 0) & (lane >= 0), lane + 1, lane)
    return np.where((base > 0) & (lane <= 0), lane - 1, lane)


def _measured(actor: ScenarioActor, scenario: IndexedScenario) -> list[Measure]:
    """What of a scene the lane is counted from, also by the name of a `let`."""
    inside = scenario.dependencies.contents(actor.options.get("lane"))
    return [value for value in inside if isinstance(value, Measure)]
