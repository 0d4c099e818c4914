"""Where agents and objects are: arc length, offset, heading, for many candidates or for one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import evaluate
from ..evaluate.kind_instance import scalar
from ..geometry.lanes import lane_ids
from ..ir.batch import RoadBatch
from ..ir.scenario import Actor
from ..ir.values import Condition, PassCall
from .placement_faults import unknown_lane
from .roads import lanes_of, road_batch

Floats = NDArray[np.float64]
MOST_COPIES = 10_000


@dataclass(frozen=True, slots=True)
class Pose:
    """Meters and radians; `start`, `offset`, `lane` where it stands on a road."""

    x: float
    y: float
    heading: float
    start: float | None = None
    offset: float | None = None
    lane: int | None = None
    facing: str = "forward"


def start_of(actor: Actor, candidates: CandidateBatch, copy: int = 1) -> Floats:
    """(V, 1) arc length at which a copy (counted from 1) of an agent or object begins."""

    def make() -> Floats:
        at = np.asarray(evaluate(actor.at, candidates, _element(actor, copy)), dtype=np.float64)
        if actor.on is None:
            raise DiagnosticError(
                diagnose(Code.START_WITHOUT_ROAD, actor.span, name=actor.name, member="start")
            )
        road = road_batch(actor.on, candidates)
        start = at * road.length if actor.at_fraction else at
        start = np.atleast_2d(start)
        if road.closed:
            start = np.mod(start, road.length)
        return np.broadcast_to(start, (candidates.count, 1))

    return candidates.once(("start", actor.name, _element(actor, copy)), make)


def counts(actor: Actor, candidates: CandidateBatch) -> NDArray[np.int64]:
    """(V,) how many copies there are. Raises RL612."""
    given = dict(actor.options).get("count")
    if given is None:
        return np.ones(candidates.count, dtype=np.int64)
    value = np.asarray(evaluate(given, candidates), dtype=np.float64).reshape(-1)
    if not ((value >= 0) & (value <= MOST_COPIES)).all():
        found = f"{float(value[(value < 0) | (value > MOST_COPIES)][0]):g}"
        raise DiagnosticError(
            diagnose(
                Code.COUNT_OUT_OF_BOUNDS, actor.span, name=actor.name, count=found, most=MOST_COPIES
            )
        )
    return np.broadcast_to(np.rint(value).astype(np.int64), (candidates.count,))


def most_copies(actor: Actor, candidates: CandidateBatch) -> int:
    """The greatest count among these candidates."""
    return int(counts(actor, candidates).max(initial=0))


def is_absent(
    condition: Condition, copy: int, candidates: CandidateBatch
) -> NDArray[np.bool_] | None:
    """(V,) candidates that do not have this copy of a group that a formula speaks of."""
    absent = None
    for entity in candidates.scenario.dependencies.entities(condition):
        if entity.role in ("agent", "object"):
            actor = candidates.scenario.actors[entity.name]
            if "count" in dict(actor.options):
                missing = counts(actor, candidates) < copy
                absent = missing if absent is None else absent | missing
    return absent


def room(actor: Actor, candidates: CandidateBatch) -> Floats:
    """(V,) meters from where each copy begins to the nearer end of its road; the least of all."""
    assert actor.on is not None
    road = road_batch(actor.on, candidates)
    if road.closed:
        return np.ones(candidates.count)
    number = counts(actor, candidates)
    least = np.full(candidates.count, np.inf)
    most = most_copies(actor, candidates) if _differs(actor, candidates) else 1
    for copy in range(1, most + 1):
        start = start_of(actor, candidates, copy)
        inside = np.minimum(start, road.length - start)[:, 0]
        # The last station is the end: rounding must not put 100% beyond it.
        inside = np.where(inside > -1e-9 * road.length[:, 0], np.maximum(inside, 0.0), inside)
        least = np.minimum(least, np.where(number >= copy, inside, np.inf))
    return np.asarray(np.minimum(least, 1e9))


def pose(actor: Actor, size: tuple[float, float], copy: int, candidates: CandidateBatch) -> Pose:
    """Where a copy stands, of a single candidate. `size`: length and width, meters."""
    element = _element(actor, copy)
    options = {
        key: scalar(evaluate(value, candidates, element))
        for key, value in actor.options
        if key in ("offset", "lane", "side", "facing", "heading")
    }
    if actor.on is None:
        x, y = scalar(evaluate(actor.at, candidates, element))
        return Pose(x, y, float(options.get("heading") or 0.0))
    return _pose_on_road(actor, options, size, copy, candidates)


def _pose_on_road(
    actor: Actor,
    options: dict[str, Any],
    size: tuple[float, float],
    copy: int,
    candidates: CandidateBatch,
) -> Pose:
    assert actor.on is not None
    road = road_batch(actor.on, candidates)
    start = float(start_of(actor, candidates, copy)[0, 0])
    x, y, direction, width = along(road, start)
    lane = options.get("lane")
    offset = _offset(actor, options, width, size[1], candidates)
    facing = options.get("facing")
    if facing not in ("forward", "back"):
        facing = "back" if lane is not None and lane > 0 else "forward"
    heading = direction + (math.pi if facing == "back" else 0.0) + (options.get("heading") or 0.0)
    return Pose(
        x - offset * math.sin(direction),
        y + offset * math.cos(direction),
        math.remainder(heading, 2 * math.pi),
        start,
        offset,
        None if lane is None else round(lane),
        facing,
    )


def _offset(
    actor: Actor, options: dict[str, Any], width: float, size: float, candidates: CandidateBatch
) -> float:
    """Meters left of the center line: from the line, a lane's middle, or outward from an edge.

    Beside the road it is the near side of the thing that stands `offset` from the edge.
    """
    offset = float(options.get("offset") or 0.0)
    if options.get("side") in ("left", "right"):
        outward = width / 2 + offset + size / 2
        return outward if options["side"] == "left" else -outward
    if options.get("lane") is None:
        return offset
    assert actor.on is not None
    return (
        lane_middle(actor, round(options["lane"]), lanes_of(actor.on, candidates), width) + offset
    )


def lane_middle(actor: Actor, lane: int, lanes: int, width: float) -> float:
    """Offset of the middle of a lane (ids as in OpenDRIVE). Raises RL613."""
    fault = unknown_lane(actor, lane, lanes)
    if fault is not None:
        raise DiagnosticError(fault)
    ids = lane_ids(lanes)
    return width * (0.5 - (ids.index(lane) + 0.5) / lanes)


def along(road: RoadBatch, start: float) -> tuple[float, float, float, float]:
    """x, y, heading and width at an arc length along the road itself (a single candidate)."""
    points, heading = road.points[0], road.heading[0]
    width = np.broadcast_to(road.width, (1, len(points)))[0]
    if road.closed:
        points = np.concatenate([points, points[:1]])
        heading = np.append(
            heading, heading[0] + 2 * np.pi * np.rint((heading[-1] - heading[0]) / (2 * np.pi))
        )
        width = np.append(width, width[0])
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    where = min(max(start, 0.0), float(arc[-1]))
    return (
        float(np.interp(where, arc, points[:, 0])),
        float(np.interp(where, arc, points[:, 1])),
        float(np.interp(where, arc, heading)),
        float(np.interp(where, arc, width)),
    )


def kind_call(actor: Actor, copy: int, candidates: CandidateBatch) -> PassCall:
    """The call of the kind that a copy is, drawn where several were named."""
    value = evaluate(actor.kind, candidates, _element(actor, copy))
    found = scalar(value)
    assert isinstance(found, PassCall)
    return found


def _element(actor: Actor, copy: int) -> int:
    return copy if "count" in dict(actor.options) else 0


def _differs(actor: Actor, candidates: CandidateBatch) -> bool:
    """Whether the copies of a group stand at different places."""
    return any(draw.per == "copy" for draw in candidates.scenario.dependencies.draws(actor.at))
