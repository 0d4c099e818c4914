"""What can be said of a requirement before any geometry: from draws and stated bounds alone."""

from __future__ import annotations

import math

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Booleans
from ..ir.values import Condition
from ..stl.evaluate.static_truth import static_truth
from .reached_values import refuting_values
from .requirement import Requirement
from .variable_bounds import CandidateBounds, ScenarioBounds

_SHOWN_PLACES = 6
"""Digits after the point of a bound in a message: less than it is widened by for rounding."""


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


def is_impossible_somewhere(requirement: Requirement, candidates: CandidateBatch) -> bool:
    """Whether what signals reach somewhere refutes a requirement, and these candidates agree."""
    return bool(_refuting(requirement, candidates)) and all(requirement.rho(candidates) < 0.0)


def reasons(requirement: Requirement, candidates: CandidateBatch) -> tuple[str, ...]:
    """Why no candidate can satisfy a requirement, in words: what its signals can be."""
    condition = requirement.test
    if not isinstance(condition, Condition):
        return ()
    if not is_impossible(requirement, candidates.scenario):
        return _refuting(requirement, candidates)
    variables = ScenarioBounds(candidates.scenario).variables(condition)
    found = []
    for binding in condition.signals:
        ends = variables[binding.variable]
        low, high = (round(float(np.ravel(end)[0]), _SHOWN_PLACES) + 0.0 for end in ends)
        unit = binding.dimension.unit.removeprefix("1")
        if math.isfinite(low) and math.isfinite(high):
            found.append(f"`{binding.variable}` is {low:.4g}{unit} to {high:.4g}{unit}")
    return tuple(found)


def _refuting(requirement: Requirement, candidates: CandidateBatch) -> tuple[str, ...]:
    condition = requirement.test
    if not isinstance(condition, Condition) or _names_group(condition, candidates.scenario):
        return ()
    return refuting_values(condition, candidates)


def _names_group(condition: Condition, scenario: IndexedScenario) -> bool:
    """Whether a formula is about the copies of a group: it holds where there are none."""
    named = (scenario.actors.get(e.name) for e in scenario.dependencies.entities(condition))
    return any(actor is not None and "count" in actor.options for actor in named)
