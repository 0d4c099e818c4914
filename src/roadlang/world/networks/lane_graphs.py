"""The lanes of networks and how they lead on: made once for all candidates that share a root."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from ...evaluate.candidates import CandidateBatch
from ...geometry import CrossSection
from ...geometry.junctions.one_way import one_way
from ...geometry.routes.lane_graph import LaneGraph, lane_graph
from ...ir.scenario import ScenarioNetwork
from ..lanes.lane_plan import lane_plan
from .junctions import edge_section
from .networks import network_root


def lanes_of_network(network: ScenarioNetwork, candidates: CandidateBatch) -> LaneGraph:
    """The lanes of a network before any `perturb`. A network that is drawn has one candidate."""

    def make(batch: CandidateBatch) -> LaneGraph:
        root = network_root(network, batch)
        plan = root.junctions.plans[network.name]
        return lane_graph(root.edges, _sections(network, batch), plan)

    is_drawn = candidates.scenario.is_varying(network.name)
    return candidates.root(("lanes of network", network.name), is_drawn, make)


def _sections(network: ScenarioNetwork, candidates: CandidateBatch) -> Mapping[int, CrossSection]:
    root = network_root(network, candidates)
    ring = root.junctions.plans[network.name].ring
    lanes = replace(lane_plan(network, candidates.scenario), speed_limit=None)
    found = {edge.id: edge_section(edge, lanes, candidates) for edge in root.edges}
    return {
        edge: one_way(section, ring[edge]) if edge in ring else section
        for edge, section in found.items()
    }
