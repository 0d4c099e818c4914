"""Where copies stand by what their statement says: arc length, lane and offset to x, y, heading."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..evaluate.copies import CopyBatch
from ..evaluate.evaluation import evaluate
from ..evaluate.kind_instance import scalar
from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.contained_values import values_in
from ..ir.scenario import ScenarioActor
from ..ir.values import Measure, PassCall, Value
from ..plugins.kinds import Standing
from .copies import element_of
from .lane_places import LanePlaces, lane_places, lanes_by_word
from .positions import Others, column, standing_of, starts_of
from .road_places import places_along


@dataclass(frozen=True, eq=False)
class Poses:
    """Arrays (R,) as in `PlacedBatch`, of the copies of a `CopyBatch`."""

    x: Floats
    y: Floats
    heading: Floats
    start: Floats
    offset: Floats
    lane: Integers
    backward: Booleans


def poses_of(
    actor: ScenarioActor, copies: CopyBatch, lengths: Floats, widths: Floats, others: Others
) -> Poses:
    """Where each copy stands; `lengths` and `widths` (R,) of the copies, in meters. Raises
    RL613."""
    if actor.on is None:
        return _in_the_world(actor, copies)
    start = starts_of(actor, copies, others)
    by = standing_of(actor, copies, others) if isinstance(actor.at, PassCall) else None
    place = places_along(actor.on, copies.candidates, copies.rows, start)
    lane = _lanes(actor, copies, by)
    lanes = lane_places(actor, copies, place, lane)
    turned = _number(actor, "heading", copies)
    across = _across(turned, lengths, widths)
    offset = _offsets(actor, copies, lanes, lane, across)
    backward = lanes.backward
    if by is not None:
        offset = offset + np.where(lane == 0, by.offset.reshape(-1), 0.0)
        backward = np.where(lane == 0, by.backward.reshape(-1), backward)
    backward = _backward(actor, copies, backward)
    heading = place.heading + np.where(backward, math.pi, 0.0) + turned
    directions = place.heading.tolist()
    sine = np.array([math.sin(direction) for direction in directions])
    cosine = np.array([math.cos(direction) for direction in directions])
    return Poses(
        place.x - offset * sine,
        place.y + offset * cosine,
        np.array([math.remainder(angle, 2 * math.pi) for angle in heading.tolist()]),
        start,
        offset,
        lane,
        backward,
    )


def _in_the_world(actor: ScenarioActor, copies: CopyBatch) -> Poses:
    x, y = (column(part, copies) for part in evaluate(actor.at, copies, element_of(actor)))
    nothing = np.full(copies.count, np.nan)
    none = np.zeros(copies.count, np.int64)
    heading = _number(actor, "heading", copies)
    return Poses(x, y, heading, nothing, nothing, none, none.astype(bool))


def _lanes(actor: ScenarioActor, copies: CopyBatch, by: Standing | None) -> Integers:
    """(R,) lane ids; 0 of what is in no lane. An agent on a road is in a lane unless it is said to
    be in none or beside the road."""
    value = _option(actor, "lane", copies)
    if value is None and by is not None and "side" not in actor.options:
        return np.asarray(by.lane, np.int64).reshape(-1)
    if value is None:
        is_agent = actor.name in copies.scenario.agents
        value = "none" if "side" in actor.options or not is_agent else "first"
    words = [_word(item) for item in _items(value)]
    if not isinstance(words[0], str):
        lane = np.rint(column(value, copies)).astype(np.int64)
        return _over_the_middle(actor, copies, lane)
    against = _is_word(_option(actor, "facing", copies), "back", copies)
    found = np.zeros(copies.count, np.int64)
    for word in sorted(set(words) - {"none"}):
        chosen = np.broadcast_to(np.array([item == word for item in words]), (copies.count,))
        found[chosen] = lanes_by_word(actor, copies, word, against)[chosen]
    return found


def _over_the_middle(actor: ScenarioActor, copies: CopyBatch, lane: Integers) -> Integers:
    """Lanes counted from that of another (`ego.start_lane + 1`) go on over the middle, which has no
    number."""
    inside = values_inside(actor.options.get("lane"))
    measured = [value for value in inside if isinstance(value, Measure)]
    if len(inside) < 2 or len(measured) != 1:
        return lane
    base = column(evaluate(measured[0], copies, element_of(actor)), copies)
    lane = np.where((base < 0) & (lane >= 0), lane + 1, lane)
    return np.where((base > 0) & (lane <= 0), lane - 1, lane)


def values_inside(value: Value | None) -> list[Value]:
    """A value and all parts of it."""
    found: list[Value] = [] if value is None else [value]
    for part in found:
        found += values_in(part)
    return found


def _items(value: Any) -> list[Any]:
    is_column = isinstance(value, np.ndarray) and value.dtype.kind in "OU"
    return value.reshape(-1).tolist() if is_column else [value]


def _word(value: Any) -> Any:
    """A word, or the name of a kind of lane."""
    return value.kind.rpartition(".")[2] if isinstance(value, PassCall) else value


def _across(turned: Floats, lengths: Floats, widths: Floats) -> Floats:
    """(R,) meters that things take across the road, turned against it."""
    sine = np.array([abs(math.sin(angle)) for angle in turned.tolist()])
    cosine = np.array([abs(math.cos(angle)) for angle in turned.tolist()])
    return np.asarray(lengths * sine + widths * cosine)


def _offsets(
    actor: ScenarioActor, copies: CopyBatch, lanes: LanePlaces, lane: Integers, across: Floats
) -> Floats:
    """(R,) meters left of the center line: from the line, a lane's middle, or outward from an edge.

    Beside the road it is the near side of the thing that stands `offset` from the edge.
    """
    offset = _number(actor, "offset", copies)
    side = _option(actor, "side", copies)
    found = np.where(lane == 0, offset, lanes.middle + offset)
    if side is None:
        return found
    outward = offset + across / 2
    found = np.where(_is_word(side, "left", copies), lanes.left + outward, found)
    return np.where(_is_word(side, "right", copies), lanes.right - outward, found)


def _backward(actor: ScenarioActor, copies: CopyBatch, by_lane: Booleans) -> Booleans:
    """(R,) whether copies face against the road: as said, or as their lane runs."""
    facing = _option(actor, "facing", copies)
    if facing is None:
        return by_lane
    back, forward = (_is_word(facing, word, copies) for word in ("back", "forward"))
    return np.where(back, True, np.where(forward, False, by_lane))


def _option(actor: ScenarioActor, name: str, copies: CopyBatch) -> Any:
    value = actor.options.get(name)
    return None if value is None else evaluate(value, copies, element_of(actor))


def _number(actor: ScenarioActor, name: str, copies: CopyBatch) -> Floats:
    value = _option(actor, name, copies)
    return np.zeros(copies.count) if value is None else column(value, copies)


def _is_word(value: Any, word: str, copies: CopyBatch) -> Booleans:
    if isinstance(value, np.ndarray):
        return np.broadcast_to(
            np.array([item == word for item in value.reshape(-1)]), (copies.count,)
        )
    return np.full(copies.count, scalar(value) == word)
