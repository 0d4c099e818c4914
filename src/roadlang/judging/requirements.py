"""All requirements of a scenario: those written, and those implied."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from ..evaluate.candidates import CandidateBatch
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry.arrays import Booleans, Floats
from ..ir.scenario import ScenarioConstraint
from ..ir.values import Condition
from .cost import cost_of
from .implied_requirements import (
    begins_on_road,
    does_not_fold,
    has_room,
    hidden_perturbations,
    is_shown_by_stations,
    perturbed_names,
)
from .influences import influences
from .requirement import Requirement
from .road_conditions import condition_rho, condition_truth
from .road_monitors import monitor_blame, monitor_rho


def requirements_of(scenario: IndexedScenario) -> tuple[Requirement, ...]:
    """All requirements of a scenario, cheapest first; the order written breaks ties."""
    found = [_written(constraint, scenario) for constraint in scenario.source.requirements]
    found += [
        begins_on_road(actor, scenario)
        for actor in scenario.actors.values()
        if actor.on is not None
    ]
    found += [has_room(actor, scenario) for actor in scenario.actors.values()]
    found += [is_shown_by_stations(name, scenario) for name in hidden_perturbations(scenario)]
    found += [does_not_fold(name, scenario) for name in perturbed_names(scenario)]
    return tuple(sorted(found, key=lambda requirement: (requirement.last, requirement.cost)))


def _written(constraint: ScenarioConstraint, scenario: IndexedScenario) -> Requirement:
    test = constraint.test
    rho: Callable[[CandidateBatch], Floats]
    truth: Callable[[CandidateBatch], Booleans] | None
    blame = None
    if isinstance(test, Condition):
        text, rho, truth = test.text, partial(condition_rho, test), partial(condition_truth, test)
    else:
        text, rho, truth = f"with {scenario.kind(test)[0].name}", partial(monitor_rho, test), None
        blame = partial(monitor_blame, constraint.name, test)
    causes = influences(test, scenario)
    return Requirement(
        name=constraint.name,
        text=text,
        rho=rho,
        truth=truth,
        cost=cost_of(test, scenario),
        names=causes.names,
        is_random=causes.is_random,
        test=test,
        span=constraint.span,
        blame=blame,
    )
