"""The lanes that a plan, or the file that a road comes from, gives it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...evaluate.kind_instance import scalar
from ...evaluate.option_bounds import check_bounds, common_option
from ...geometry import CrossSection, Lane, WidthProfile
from ...geometry.arrays import Floats
from ...geometry.lanes.lanes import DEFAULT_LANES, Direction, Marking
from ...ir.values import ConstantValue, PassCall, Value
from ...plugins.kinds import LaneKind
from .cross_sections import LaneBatch
from .lane_plan import LanePlan, default_lane_kind, lane_calls, side_directions, traffic_side

_UNIT = WidthProfile.constant(1.0)
_DOUBLE = 4
"""From so many driving lanes on the directions are parted by a double line."""


def built_lanes(
    plan: LanePlan,
    candidates: CandidateBatch,
    section: CrossSection | None = None,
    count: int | None = None,
) -> LaneBatch:
    """The lanes that are written, else those of `section`, else `count` driving lanes, else two.

    The candidates must have the same lanes: one candidate, or a plan that `is_fixed`. Raises RL473
    for a drawn width or limit that is out of bounds.
    """
    limit = None if plan.speed_limit is None else evaluate(plan.speed_limit, candidates)
    if plan.has_lists:
        found = _listed(plan, candidates)
    elif plan.lanes is None and section is not None:
        found = LaneBatch(section, {}, {})
    else:
        found = _counted(plan, candidates, count or DEFAULT_LANES)
    if plan.center_marking is not None:
        marking = _fixed(plan.center_marking, candidates)
        found = replace(found, pattern=replace(found.pattern, center_marking=marking))
    if limit is not None:
        lanes = (lane for lane in found.pattern.lanes if lane.speed_limit is None)
        limits = {lane.id: limit for lane in lanes if lane.drivable}
        found = replace(found, speed_limits={**limits, **found.speed_limits})
    return replace(found, source=plan.source)


def _counted(plan: LanePlan, candidates: CandidateBatch, count: int) -> LaneBatch:
    if plan.lanes is not None:
        count = max(1, round(float(_fixed(plan.lanes, candidates))))
    oneway = plan.oneway is not None and bool(_fixed(plan.oneway, candidates))
    share = WidthProfile.constant(float(count))
    section = CrossSection.of_lane_count(count, share, oneway=oneway)
    kind = default_lane_kind(candidates.scenario, drivable=True)
    named = (replace(lane, kind=kind.name, users=kind.users) for lane in section.lanes)
    section = replace(section, lanes=tuple(named))
    widths: dict[int, Any] = {}
    if plan.sidewalks is not None:
        width = np.atleast_2d(np.asarray(evaluate(plan.sidewalks, candidates), float))
        section = _with_sidewalks(section, default_lane_kind(candidates.scenario, drivable=False))
        widths = {section.ids[0]: width, section.ids[-1]: width}
    if left_hand(candidates):
        section, widths = section.mirrored(), {-id: width for id, width in widths.items()}
    return LaneBatch(section, widths, {})


def _with_sidewalks(section: CrossSection, kind: type[LaneKind]) -> CrossSection:
    ids = section.ids
    left, right = max(ids[0], 0) + 1, min(ids[-1], 0) - 1
    lanes = [
        replace(lane, marking="curb") if lane.id in (left - 1, right + 1) else lane
        for lane in section.lanes
    ]
    walks = [_lane(id, kind, "forward", "none") for id in (left, right)]
    center: Marking = section.center_marking if left > 1 and right < -1 else "curb"
    return CrossSection((walks[0], *lanes, walks[1]), center)


def _listed(plan: LanePlan, candidates: CandidateBatch) -> LaneBatch:
    oneway = plan.oneway is not None and bool(_fixed(plan.oneway, candidates))
    sides = [_calls(value, candidates) for value in (plan.left, plan.right)]
    directions = side_directions(oneway, left_hand(candidates))
    lanes: dict[int, Lane] = {}
    widths: dict[int, Any] = {}
    limits: dict[int, Any] = {}
    sharing: list[int] = []
    for sign, calls, direction in zip((1, -1), sides, directions, strict=True):
        kinds = [_kind(call, candidates.scenario) for call in calls]
        for place, (call, kind) in enumerate(zip(calls, kinds, strict=True)):
            id, outer = sign * (place + 1), kinds[place + 1] if place + 1 < len(kinds) else None
            written = call.common
            lanes[id] = _lane(id, kind, direction, _marking(kind, outer, written, candidates))
            width = _number("width", call, candidates, kind.default_width)
            widths[id] = np.atleast_2d(np.asarray(width, float))
            if kind.drivable and "width" not in written:
                sharing.append(id)
            if "speed_limit" in written:
                limits[id] = _number("speed_limit", call, candidates, 0.0)
    ordered = tuple(lanes[id] for id in sorted(lanes, reverse=True))
    found = LaneBatch(CrossSection(ordered, _center(lanes)), widths, limits)
    width = plan.owner.options.get("width") if plan.owner is not None else None
    if width is None or not sharing:
        return found
    return _shared(found, sharing, np.atleast_2d(np.asarray(evaluate(width, candidates), float)))


def _shared(lanes: LaneBatch, sharing: list[int], width: Floats) -> LaneBatch:
    """The lanes at `sharing` get equal parts of what the others leave of the width."""
    others = lanes.extent() - sum(lanes.widths[id] for id in sharing)
    rest = np.maximum((width - others) / len(sharing), 0.0)
    return replace(lanes, widths={**lanes.widths, **dict.fromkeys(sharing, rest)})


def _lane(id: int, kind: type[LaneKind], direction: Direction, marking: Marking) -> Lane:
    runs: Direction = direction if kind.direction == "side" else kind.direction
    users = tuple(kind.users)
    return Lane(id, kind.name, _UNIT, runs, kind.drivable, None, marking, users, kind.raised)


def _marking(
    kind: type[LaneKind],
    outer: type[LaneKind] | None,
    written: dict[str, Value],
    candidates: CandidateBatch,
) -> Marking:
    """The line toward the outer neighbor: as written, as usual for the kind, or what fits."""
    if "marking" in written:
        found: Marking = _fixed(written["marking"], candidates)
        return found
    if kind.default_marking != "auto":
        return kind.default_marking
    if kind.raised != (outer is not None and outer.raised):
        return "none" if outer is None else "curb"
    if kind.raised:
        return "none"
    return "broken" if outer is kind and kind.direction == "side" else "solid"


def _center(lanes: dict[int, Lane]) -> Marking:
    """The line between the innermost lanes of both sides, or along the edge of the only side."""
    left, right = lanes.get(1), lanes.get(-1)
    raised = [lane is not None and lane.raised for lane in (left, right)]
    if raised[0] != raised[1]:
        return "curb" if left is not None and right is not None else "none"
    if raised[0] and raised[1]:
        return "none"
    if left is None or right is None or not (left.drivable and right.drivable):
        return "solid"
    if left.direction == right.direction:
        return "broken"
    return "broken" if sum(lane.drivable for lane in lanes.values()) < _DOUBLE else "double"


def _calls(value: Value | None, candidates: CandidateBatch) -> tuple[PassCall, ...]:
    """The calls of a list, from the middle outwards; of a single candidate where they are drawn."""
    found = lane_calls(value, candidates.scenario)
    if found is not None:
        return found
    assert value is not None
    drawn: tuple[PassCall, ...] = scalar(evaluate(value, candidates))
    return drawn


def _kind(call: PassCall, scenario: IndexedScenario) -> type[LaneKind]:
    kind: Any = scenario.kind(call)[1]
    found: type[LaneKind] = kind
    return found


def _number(name: str, call: PassCall, candidates: CandidateBatch, default: float) -> Any:
    """A width or limit of a lane: a number, or a column of those that are drawn. Raises RL473."""
    value = call.common.get(name)
    if value is None:
        return default
    if isinstance(value, ConstantValue):
        return value.value
    found = evaluate(value, candidates)
    check_bounds(common_option("lane", name), found, call)
    return found


def left_hand(candidates: CandidateBatch) -> bool:
    """Whether vehicles drive on the left, of candidates alike in this."""
    return bool(_fixed(traffic_side(candidates.scenario), candidates) == "left")


def _fixed(value: Value, candidates: CandidateBatch) -> Any:
    return scalar(evaluate(value, candidates))
