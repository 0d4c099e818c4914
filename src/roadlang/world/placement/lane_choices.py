"""Which lanes of a network copies may be in: by `lane` and `facing`, or those of its usual kind."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Any, TypeAlias

import numpy as np

from ...diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ...evaluate.copies import CopyBatch
from ...geometry.routes.lane_graph import LaneGraph
from ...ir.scenario import ScenarioActor
from ...ir.values import PassCall
from .lane_places import is_on_side
from .road_poses import WrittenPlace, option_value
from .usual_lanes import lanes_on_foot, walk_at_side

LaneChoice: TypeAlias = tuple[str | int, str, str]
"""`any`, a number, `outer` or a kind of lane; `forward`, `back` or neither; `left`, `right` or
neither"""


def lane_choices(
    actor: ScenarioActor, copies: CopyBatch, place: WrittenPlace, lanes: LaneGraph
) -> list[LaneChoice | None]:
    """(R) what each copy may be in; None of what is in no lane."""
    value = option_value(actor, "lane", copies)
    if value is None:
        in_lane = actor.name in copies.scenario.agents and not actor.is_beside_road
        items: list[Any] = ["any" if in_lane else "none"]
        on_foot = walk_at_side(actor, copies) if in_lane else None
        if on_foot is not None and (kind := _kind_on_foot(lanes)):
            items = np.where(on_foot, kind, items[0]).tolist()
    elif isinstance(value, np.ndarray):
        items = value.reshape(-1).tolist()
    else:
        items = [value]
    items = items * copies.count if len(items) == 1 else items
    said = zip(items, place.facing.tolist(), place.side.tolist(), strict=True)
    return [_choice(item, facing, side) for item, facing, side in said]


def _choice(item: Any, facing: str, side: str) -> LaneChoice | None:
    if isinstance(item, PassCall):
        item = item.kind.rpartition(".")[2]
    if item == "none":
        return None
    return (item if isinstance(item, str) else round(item)), facing, side


def is_for_vehicles(choice: LaneChoice, lanes: LaneGraph) -> bool:
    """Whether a choice is about lanes for vehicles, not a kind such as `parking`."""
    if isinstance(choice[0], int) or choice[0] in ("any", "outer"):
        return True
    return any(_kind(lanes, number) == choice[0] for number in range(len(lanes.lanes)))


def allowed_lanes(
    actor: ScenarioActor, lanes: LaneGraph, choice: LaneChoice, copies: CopyBatch
) -> frozenset[int]:
    """The lanes of a network that a choice allows. Raises RL613 if it is none."""
    default_kind = copies.scenario.registry.default("lane").name
    found = frozenset(
        number
        for number in _of_choice(lanes, choice[0], default_kind)
        if is_on_side(lanes.lanes[number].lane, choice[2])
    )
    facing = {"forward": False, "back": True}.get(choice[1])
    if facing is not None:
        found = frozenset(lane for lane in found if lanes.lanes[lane].backward == facing)
    if not found:
        raise DiagnosticError(_missing_lane(actor, lanes, choice))
    return found


def _missing_lane(actor: ScenarioActor, lanes: LaneGraph, choice: LaneChoice) -> Diagnostic:
    """RL613, of a network without a lane that a choice allows."""
    known = sorted({lane.lane for lane in lanes.lanes}, key=lambda id: (abs(id), id))
    help_ = f"its lanes for vehicles are {', '.join(map(str, known))}"
    lane = f"`{choice[0]}`" if isinstance(choice[0], str) else str(choice[0])
    if not known:
        lane = "for vehicles outside its junctions"
        help_ = "its roads are too short for the width of their lanes: look at its `scale`"
    elif choice[0] == "any":
        lane = f"for vehicles that runs {'against' if choice[1] == 'back' else 'along'} its roads"
    return diagnose(Code.UNKNOWN_LANE, actor.span_of("lane"), road=actor.on, lane=lane, help=help_)


def _of_choice(lanes: LaneGraph, choice: Hashable, default_kind: str) -> list[int]:
    if choice == "any":
        return [
            n for group in _carriageways(lanes) for n in _default_lanes(lanes, group, default_kind)
        ]
    if choice == "outer":
        return [
            max(group, key=lambda n: abs(lanes.lanes[n].lane)) for group in _carriageways(lanes)
        ]
    by_id = isinstance(choice, int)
    return [
        number
        for number, lane in enumerate(lanes.lanes)
        if choice == (lane.lane if by_id else _kind(lanes, number))
    ]


def _carriageways(lanes: LaneGraph) -> list[tuple[int, ...]]:
    return sorted(set(lanes.carriageways))


def _default_lanes(lanes: LaneGraph, group: tuple[int, ...], default_kind: str) -> list[int]:
    return [n for n in group if _kind(lanes, n) == default_kind] or list(group)


def _kind_on_foot(lanes: LaneGraph) -> str:
    """The kind of lane that pedestrians have on some road, "" where they have none."""
    sections = (lanes.sections[edge] for edge in lanes.of_edge)
    return next((s.lane(id).kind for s in sections for id in lanes_on_foot(s)), "")


def _kind(lanes: LaneGraph, number: int) -> str:
    lane = lanes.lanes[number]
    return lanes.sections[lane.edge].lane(lane.lane).kind
