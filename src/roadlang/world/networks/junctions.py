"""The junctions of a network: planned once for all candidates that share its root."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry import CrossSection, Edge, RoadNetwork
from ...geometry.arrays import Floats
from ...geometry.junctions.one_way import one_way
from ...geometry.networks.junction_model import JunctionPlan
from ...ir.scenario import ScenarioNetwork
from ...ir.values import Flag
from ..lanes.lane_building import built_lanes, left_hand
from ..lanes.lane_plan import LanePlan, lane_plan

_CLOSE = 0.01
_HAIR = 1e-6
"""Meters from which on a road is free that begins at the edge of its junction."""


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
            inner = [start] if start > 0.0 else []
            inner += [length - end] if end > 0.0 else []
            for trim in inner:
                place = int(np.abs(found - trim).argmin())
                is_end = place in (0, len(found) - 1)
                if abs(found[place] - trim) <= (1e-9 if is_end else close):
                    found[place] = found[place] if is_end else trim
                else:
                    found = np.insert(found, np.searchsorted(found, trim), trim)
        return found

    def frozen(self, edge: int, stations: Floats, length: float) -> tuple[float, float]:
        """How far from each end a road must stay where it is: a station further than its trims, so
        that the differences over stations vanish at the faces too; two at the very end of a road,
        where they are of the three next to it."""
        start, end = self.trims[edge]
        after = max(int(np.searchsorted(stations, start + 1e-9)), 2)
        before = int(np.searchsorted(stations, length - end - 1e-9)) - 1
        before = min(before, len(stations) - 3)
        if after > before:
            return length / 2.0, length / 2.0
        return (
            float(stations[after]) if start else 0.0,
            float(length - stations[before]) if end else 0.0,
        )


def network_plans(
    bottom: ScenarioNetwork, geometry: RoadNetwork, candidates: CandidateBatch
) -> NetworkPlans:
    """The plans of a network and of those made from it, which may have other lanes.

    The candidates must have the same lanes. Raises RL473 for a drawn width that is out of bounds.
    """
    # Twenty modules, for scenarios with networks alone.
    from ...geometry.junctions.plan import PlanOptions, plan_junctions

    scenario = candidates.scenario
    side = left_hand(candidates)
    by_lanes: dict[tuple[LanePlan, bool], JunctionPlan] = {}
    plans: dict[str, JunctionPlan] = {}
    for network in scenario.networks.values():
        if bottom not in scenario.chain(network):
            continue
        lanes = replace(lane_plan(network, scenario), speed_limit=None)
        key = lanes, has_u_turns(network, scenario)
        if key not in by_lanes:
            sections = {edge.id: edge_section(edge, lanes, candidates) for edge in geometry.edges}
            options = PlanOptions(side, u_turns=key[1])
            by_lanes[key] = plan_junctions(geometry, sections, options)
        plans[network.name] = by_lanes[key]
    return NetworkPlans(plans, _greatest(geometry, plans.values()))


def has_u_turns(network: ScenarioNetwork, scenario: IndexedScenario) -> bool:
    """Whether vehicles may turn around at its junctions, as it says or what it is made from."""
    chain = [link for link in scenario.chain(network) if isinstance(link, ScenarioNetwork)]
    written = [link.options["u_turns"] for link in chain if "u_turns" in link.options]
    return bool(written) and scenario.resolved(written[0]) == Flag(True)


def edge_section(edge: Edge, lanes: LanePlan, candidates: CandidateBatch) -> CrossSection:
    """The lanes of an edge before any `perturb`, of candidates that have the same ones."""
    built = built_lanes(lanes, candidates, edge.cross_section)
    built = replace(built, pattern=directed(built.pattern, edge))
    return built.cross_section(edge.width, edge.width.stations)


def directed(pattern: CrossSection, edge: Edge) -> CrossSection:
    """The lanes of an edge, all in its direction where it has one: whoever drew that the road
    leads west did not mean with `oneway` that it leads from its start to its end."""
    if edge.forward is None:
        return pattern
    both = replace(
        pattern,
        lanes=tuple(
            replace(lane, direction="both") if lane.drivable else lane for lane in pattern.lanes
        ),
    )
    return one_way(both, edge.forward)


def _greatest(
    geometry: RoadNetwork, plans: Iterable[JunctionPlan]
) -> dict[int, tuple[float, float]]:
    found = {edge.id: (0.0, 0.0) for edge in geometry.edges}
    for plan in plans:
        for edge, (start, end) in plan.trims.items():
            found[edge] = max(found[edge][0], start), max(found[edge][1], end)
        for arm in (arm for junction in plan.junctions for arm in junction.arms):
            start, end = found[arm.edge]
            at_start = arm.end == "start"
            found[arm.edge] = max(start, _HAIR * at_start), max(end, _HAIR * (not at_start))
    return found
