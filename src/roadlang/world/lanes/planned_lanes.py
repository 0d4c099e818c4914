"""The lanes of a road as far as they are known before anything is drawn. Imports no numpy."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, cast

from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry.lanes.lanes import Direction
from ...ir.values import Flag
from ...plugins.kinds import LaneKind
from .lane_plan import LanePlan, default_lane_kind, is_left, known_ids, lane_calls, side_directions


@dataclass(frozen=True)
class PlannedLane:
    """A lane, without its width."""

    id: int
    kind: type[LaneKind]
    direction: Direction


def planned_lanes(plan: LanePlan, scenario: IndexedScenario) -> tuple[PlannedLane, ...] | None:
    """From left to right; None where `known_ids` is None."""
    ids = known_ids(plan, scenario)
    if ids is None:
        return None
    kinds = _listed(plan, scenario) if plan.has_lists else _counted(plan, ids, scenario)
    left, right = side_directions(plan.oneway == Flag(True), is_left(scenario))
    sides = (left if id > 0 else right for id in ids)
    return tuple(
        PlannedLane(id, kind, side if kind.direction == "side" else kind.direction)
        for id, kind, side in zip(ids, kinds, sides, strict=True)
    )


def _listed(plan: LanePlan, scenario: IndexedScenario) -> list[type[LaneKind]]:
    left, right = (lane_calls(value, scenario) or () for value in (plan.left, plan.right))
    return [cast(Any, scenario.kind(call)[1]) for call in (*reversed(left), *right)]


def _counted(
    plan: LanePlan, ids: tuple[int, ...], scenario: IndexedScenario
) -> list[type[LaneKind]]:
    """Driving lanes, between sidewalks where the plan has them."""
    kinds = [default_lane_kind(scenario, drivable=True)] * len(ids)
    if plan.sidewalks is not None:
        kinds[0] = kinds[-1] = default_lane_kind(scenario, drivable=False)
    return kinds
