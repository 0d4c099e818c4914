"""The junctions of a network: planned once for all candidates that share its root."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ..evaluate.candidates import fixed_candidate
from ..evaluate.indexed_scenario import IndexedScenario
from ..geometry import CrossSection, RoadNetwork
from ..geometry.junctions.model import JunctionPlan
from ..geometry.junctions.plan import PlanOptions, plan_junctions
from ..ir.scenario import ScenarioNetwork
from .lane_building import built_lanes
from .lane_plan import LanePlan, is_left, lane_plan

Floats = NDArray[np.float64]
_CLOSE = 0.01


@dataclass(frozen=True)
class NetworkPlans:
    """The plans of all networks that derive from one root, by name.

    `trims` are the greatest of all plans: no road is displaced before them, so that every plan
    holds whatever displaces the roads.
    """

    plans: Mapping[str, JunctionPlan] = field(default_factory=dict)
    trims: Mapping[int, tuple[float, float]] = field(default_factory=dict)

    def stations(self, edge: int, stations: Floats, length: float) -> Floats:
        """(S,) stations of a road and its trims, to which a station that is very close is moved."""
        close = _CLOSE * length / len(stations)
        found = stations.copy()
        for start, end in sorted({plan.trims[edge] for plan in self.plans.values()}):
            for trim in (start, length - end):
                place = int(np.abs(found - trim).argmin())
                is_end = place in (0, len(found) - 1)
                if abs(found[place] - trim) <= (1e-9 if is_end else close):
                    found[place] = found[place] if is_end else trim
                else:
                    found = np.insert(found, np.searchsorted(found, trim), trim)
        return found

    def frozen(self, edge: int, stations: Floats, length: float) -> tuple[float, float]:
        """How far from each end a road must stay where it is: a station further than its trims, so
        that the differences over stations vanish at the faces too."""
        start, end = self.trims[edge]
        after = np.searchsorted(stations, start + 1e-9)
        before = np.searchsorted(stations, length - end - 1e-9) - 1
        if after > before:
            return length / 2.0, length / 2.0
        return (
            float(stations[after]) if start else 0.0,
            float(length - stations[before]) if end else 0.0,
        )


def network_plans(
    bottom: ScenarioNetwork, geometry: RoadNetwork, scenario: IndexedScenario
) -> NetworkPlans:
    """The plans of a network and of those made from it."""
    made: dict[LanePlan, JunctionPlan] = {}
    plans: dict[str, JunctionPlan] = {}
    for network in scenario.networks.values():
        if list(_networks(network, scenario))[-1] is bottom:
            plan = lane_plan(network, scenario)
            key = replace(plan, owner=None, speed_limit=None)
            if key not in made:
                options = PlanOptions(left_hand=is_left(scenario))
                made[key] = plan_junctions(geometry, _sections(plan, geometry, scenario), options)
            plans[network.name] = made[key]
    return NetworkPlans(plans, _greatest(geometry, plans.values()))


def _networks(network: ScenarioNetwork, scenario: IndexedScenario) -> Iterable[ScenarioNetwork]:
    return (link for link in scenario.chain(network) if isinstance(link, ScenarioNetwork))


def _sections(
    plan: LanePlan, geometry: RoadNetwork, scenario: IndexedScenario
) -> dict[int, CrossSection]:
    candidate = fixed_candidate(scenario)
    return {
        edge.id: built_lanes(plan, candidate, edge.cross_section).cross_section(
            edge.width, edge.width.stations
        )
        for edge in geometry.edges
    }


def _greatest(
    geometry: RoadNetwork, plans: Iterable[JunctionPlan]
) -> dict[int, tuple[float, float]]:
    found = {edge.id: (0.0, 0.0) for edge in geometry.edges}
    for plan in plans:
        for edge, (start, end) in plan.trims.items():
            found[edge] = max(found[edge][0], start), max(found[edge][1], end)
    return found
