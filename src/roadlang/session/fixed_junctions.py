"""Junctions and roads that a `control` pass names and that a typed picture does not have."""

from __future__ import annotations

from collections.abc import Iterator

from ..diagnostics import Code, Diagnostic, DiagnosticError
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioImage, ScenarioNetwork, TextSource

_CODES = (Code.UNKNOWN_JUNCTION_ID, Code.UNKNOWN_ROAD_ID, Code.ROAD_NOT_AT_JUNCTION)


def fixed_junctions(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL429, RL411 and RL430 of networks that are the same in every scene and cost little: those
    of typed pictures. Only where such a pass names junctions or roads is the network made."""
    for network in scenario.networks.values():
        if _names_places(network) and _is_typed(network, scenario):
            fault = _fault(network, scenario)
            if fault is not None:
                yield fault


def _names_places(network: ScenarioNetwork) -> bool:
    controls = [call for call in network.passes if call.verb == "control"]
    return any("junctions" in call.common or "roads" in call.options for call in controls)


def _is_typed(network: ScenarioNetwork, scenario: IndexedScenario) -> bool:
    chain = list(scenario.chain(network))
    images = [link for link in chain if isinstance(link, ScenarioImage)]
    typed = bool(images) and isinstance(images[-1].source, TextSource)
    return typed and not scenario.is_varying(network.name)


def _fault(network: ScenarioNetwork, scenario: IndexedScenario) -> Diagnostic | None:
    from ..evaluate.candidates import fixed_candidate
    from ..world.index import index_scenario
    from ..world.junction_control import right_of_way_rules

    candidate = fixed_candidate(index_scenario(scenario.source, scenario.registry))
    try:
        right_of_way_rules(candidate.scenario.networks[network.name], candidate)
    except DiagnosticError as error:
        found = [fault for fault in error.diagnostics if fault.code in _CODES]
        return found[0] if found else None  # other faults are reported where they arise
    return None
