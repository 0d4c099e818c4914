"""Small networks whose junctions are known, and their plans."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from roadlang.geometry import RoadNetwork, network_of_polylines
from roadlang.geometry.junctions.plan import PlanOptions, plan_junctions
from roadlang.geometry.lanes.cross_section import CrossSection
from roadlang.geometry.networks.junction_model import Junction, JunctionPlan


def sections_of(
    network: RoadNetwork, lanes: int | Sequence[int] = 2, one_way: Sequence[int] = ()
) -> dict[int, CrossSection]:
    """Equal lanes for each road; those in `one_way` run from start to end."""
    counts = [lanes] * len(network.edges) if isinstance(lanes, int) else list(lanes)
    return {
        edge.id: CrossSection.of_lane_count(count, edge.width, oneway=edge.id in one_way)
        for edge, count in zip(network.edges, counts, strict=True)
    }


def star(*degrees: float, length: float = 100.0, width: Any = 7.0) -> RoadNetwork:
    """Straight roads from the origin."""
    lines = [
        [(0.0, 0.0), (length * math.cos(math.radians(d)), length * math.sin(math.radians(d)))]
        for d in degrees
    ]
    return network_of_polylines(lines, width)


def plan_of(
    network: RoadNetwork,
    lanes: int | Sequence[int] = 2,
    one_way: Sequence[int] = (),
    options: PlanOptions | None = None,
) -> JunctionPlan:
    return plan_junctions(network, sections_of(network, lanes, one_way), options)


def only(plan: JunctionPlan) -> Junction:
    """The junction of a plan that has one."""
    (junction,) = plan.junctions
    return junction
