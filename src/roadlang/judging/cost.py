"""What a requirement costs to evaluate, so that cheap ones are tried first."""

from __future__ import annotations

from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.values import Condition, PassCall

_MONITOR = 100.0
_TEMPORAL_OPERATOR = 4.0
_PROJECTION = 4000.0
"""How much more it costs to find the nearest point of another road than to compare stations"""


def cost_of(test: Condition | PassCall, scenario: IndexedScenario) -> float:
    """The work for one station, in displacements: what kinds say, and the temporal operators."""
    inside = (
        value for value in scenario.dependencies.contents(test) if isinstance(value, PassCall)
    )
    calls = [call for call in inside if call.verb in ("signal", "number", "monitor")]
    work = sum(
        scenario.kind(call)[1].cost * (_PROJECTION if _compares_roots(call, scenario) else 1.0)
        for call in calls
    )
    if isinstance(test, Condition):
        return work + _TEMPORAL_OPERATOR * sum(node.temporal for node in test.formula.walk())
    return work + _MONITOR


def _compares_roots(call: PassCall, scenario: IndexedScenario) -> bool:
    """Whether a call compares roads of different roots, by the nearest point."""
    roots = set()
    for entity in scenario.dependencies.entities(call):
        if entity.name in scenario.roads or entity.name in scenario.networks:
            chain = scenario.chain(scenario.declaration(entity.name))
            links = [link for link in chain if link.name not in scenario.images]
            roots.add((links[-1].name, any(link.name in scenario.roads for link in links)))
    return len(roots) > 1
