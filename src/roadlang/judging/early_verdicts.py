"""What can be said of a requirement before any geometry: from draws and stated bounds alone."""

from __future__ import annotations

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Booleans
from ..ir.values import Condition
from ..stl.evaluate.static_truth import static_truth
from .requirement import Requirement
from .variable_bounds import CandidateBounds, ScenarioBounds


def settled_rows(requirement: Requirement, candidates: CandidateBatch) -> Booleans:
    """(V,) True where a requirement is certain to hold, whatever the geometry."""
    condition = requirement.test
    if not isinstance(condition, Condition) or condition.domain != "road":
        return np.zeros(candidates.count, dtype=bool)
    if condition.evaluation.strict:  # which windows hold a sample is not known here
        return np.zeros(candidates.count, dtype=bool)
    variables = CandidateBounds(candidates).variables(condition)
    certain = static_truth(condition.formula, variables).certain
    return np.broadcast_to(certain, (candidates.count,))


def is_impossible(requirement: Requirement, scenario: IndexedScenario) -> bool:
    """Whether no candidate of the scenario can satisfy a requirement, as far as bounds tell."""
    condition = requirement.test
    if not isinstance(condition, Condition) or _names_group(condition, scenario):
        return False
    variables = ScenarioBounds(scenario).variables(condition)
    return not static_truth(condition.formula, variables).possible


def _names_group(condition: Condition, scenario: IndexedScenario) -> bool:
    """Whether a formula is about the copies of a group: it holds where there are none."""
    named = (scenario.actors.get(e.name) for e in scenario.dependencies.entities(condition))
    return any(actor is not None and "count" in actor.options for actor in named)
