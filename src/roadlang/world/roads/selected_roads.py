"""Roads that run over the roads of a network, since they were selected from it."""

from __future__ import annotations

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry import Step
from ...ir.scenario import LANE_OPTIONS, ScenarioNetwork, ScenarioRoad
from ...ir.scene_road import RoadPart
from .road_places import from_root
from .roads import road_root

_ROWS = np.zeros(2, np.intp)


def parts_of_network(road: ScenarioRoad, candidates: CandidateBatch) -> tuple[RoadPart, ...]:
    """What a road of a single candidate runs over; nothing, where it was not selected from a
    network, or was perturbed since."""
    found = steps_in_network(road, candidates)
    if found is None:
        return ()
    network, steps = found
    return tuple(_part(network, step, candidates) for step in steps)


def steps_in_network(
    road: ScenarioRoad, candidates: CandidateBatch
) -> tuple[ScenarioNetwork, tuple[Step, ...]] | None:
    """The network that a road was selected from, and its way there by arc lengths of the roots;
    None of a road that lies elsewhere."""
    if is_perturbed(road, candidates.scenario):
        return None
    root = road_root(road.name, candidates)
    if root.network is None or root.path is None:
        return None
    return root.network, root.path.steps


def has_lanes_of_network(road: ScenarioRoad, scenario: IndexedScenario) -> bool:
    """Whether a road has the lanes and widths of the network that it was selected from."""
    links = [link for link in scenario.chain(road) if isinstance(link, ScenarioRoad)]
    across = {"width", *LANE_OPTIONS} - {"speed_limit"}
    return not any(link.options.keys() & across for link in links)


def is_perturbed(road: ScenarioRoad, scenario: IndexedScenario) -> bool:
    """Whether a road, or one that it is made from, is perturbed; its network does not count."""
    links = [link for link in scenario.chain(road) if isinstance(link, ScenarioRoad)]
    return any(call.verb == "perturb" for link in links for call in link.passes)


def _part(network: ScenarioNetwork, step: Step, candidates: CandidateBatch) -> RoadPart:
    name = f"{network.name}/{step.edge}"
    start, stop = from_root(name, candidates, _ROWS, np.array([step.start, step.stop])).tolist()
    return RoadPart(name, start, stop)
