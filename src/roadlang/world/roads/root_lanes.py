"""The lanes of a road, on the root that it goes back to."""

from __future__ import annotations

from ...evaluate.candidates import CandidateBatch
from ...geometry import Path
from ...ir.scenario import ScenarioNetwork
from ..lanes.cross_sections import LaneBatch
from ..lanes.lane_building import built_lanes
from ..lanes.lane_plan import LanePlan
from .road_root import RoadRoot


def lanes_on_root(plan: LanePlan, root: RoadRoot, candidates: CandidateBatch) -> LaneBatch:
    """What is written of the lanes of a road, else what its root has.

    The candidates must have the same lanes, as for `built_lanes`.
    """
    lanes = built_lanes(plan, candidates, root.section, root.lanes)
    return lanes.reversed(root.frame.curve.length) if _is_reversed(plan, root) else lanes


def _is_reversed(plan: LanePlan, root: RoadRoot) -> bool:
    """Whether lanes that a network gives are seen from the other end: most of a path through it
    runs against the direction of the edges."""
    return isinstance(plan.owner, ScenarioNetwork) and _runs_backward(root.path)


def _runs_backward(path: Path | None) -> bool:
    steps = () if path is None else path.steps
    return sum(step.stop - step.start for step in steps) < 0.0
