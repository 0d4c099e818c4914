"""How wide roads are where nothing has measured them: as wide as their lanes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...geometry import RoadNetwork
from ...ir.scenario import ScenarioNetwork
from .lane_building import built_lanes
from .lane_plan import lane_plan

LANE_WIDTH = 3.5
"""Meters, of counted lanes."""


def as_wide_as_lanes(
    network: ScenarioNetwork, found: RoadNetwork, candidates: CandidateBatch
) -> RoadNetwork:
    """The same roads with the widths of their lanes, as listed or 3.5 m each.

    Counted lanes get no more than the widths found, for which there is room in the picture.
    """
    plan = lane_plan(network, candidates.scenario)
    lanes = built_lanes(plan, candidates.take(np.array([0])))
    drivable = [lane for lane in lanes.pattern.lanes if lane.drivable]
    if plan.has_lists:
        widths = [float(lanes.extent().max())] * len(found.edges)
    else:
        widths = [min(LANE_WIDTH * len(drivable), float(edge.widths.min())) for edge in found.edges]
    edges = (
        replace(edge, widths=np.full(1, width))
        for edge, width in zip(found.edges, widths, strict=True)
    )
    return replace(found, edges=tuple(edges))
