"""Where copies stand by what their statement says, on a road, in a network or in the world."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import evaluate
from ...geometry.arrays import Floats, Integers
from ...ir.scenario import ScenarioActor
from ...ir.values import PassCall
from ...plugins.kinds import Standing
from .actor_numbers import column, number_of_copies
from .copies import element_of
from .lane_places import lanes_by_word
from .network_places import begins_in_network
from .positions import Others, standing_of, starts_of
from .relative_lanes import over_the_middle
from .road_poses import (
    NO_ROAD,
    LaneStart,
    RoadPoses,
    WrittenPlace,
    option_value,
    poses_on_road,
)
from .spots import NoPlace
from .usual_lanes import ON_FOOT, walk_at_side

WIDTH_WITHOUT_ROAD = 7.0
"""Meters, of a crosswalk that is on no road and does not say how wide it is"""


def poses_of(
    actor: ScenarioActor, copies: CopyBatch, lengths: Floats, widths: Floats, others: Others
) -> RoadPoses:
    """Where each copy stands; `lengths` and `widths` (R,) of the copies, in meters. Raises
    RL613."""
    if actor.on is None:
        return _in_the_world(actor, copies, widths)
    written, sizes = WrittenPlace.of(actor, copies), (lengths, widths)
    if actor.on in copies.scenario.networks:
        return _in_network(actor, copies, written, sizes, others)
    begin = _begin(actor, copies, written, others)
    return poses_on_road(actor.on, actor, copies.candidates, copies.rows, begin, written, sizes)


def _in_the_world(actor: ScenarioActor, copies: CopyBatch, widths: Floats) -> RoadPoses:
    x, y = (column(part, copies) for part in evaluate(actor.at, copies, element_of(actor)))
    nothing = np.full(copies.count, np.nan)
    none = np.zeros(copies.count, np.int64)
    heading = number_of_copies(actor, "heading", copies, 0.0)
    road = np.full(copies.count, NO_ROAD)
    no = none.astype(bool)
    width = np.where(np.isnan(widths), WIDTH_WITHOUT_ROAD, widths)
    lacking = np.zeros(copies.count)
    return RoadPoses(x, y, heading, nothing, nothing, none, no, road, lacking, width, none, none)


def _in_network(
    actor: ScenarioActor,
    copies: CopyBatch,
    written: WrittenPlace,
    sizes: tuple[Floats, Floats],
    others: Others,
) -> RoadPoses:
    """Road by road."""
    road, begin, lacking, no_place = begins_in_network(actor, copies, written, sizes[0], others)
    found = [np.zeros(copies.count) for _ in range(6)]
    lane, backward = np.zeros(copies.count, np.int64), np.zeros(copies.count, dtype=bool)
    missing_lane = lane.copy()
    columns = [*found, lane, backward, missing_lane]
    for edge in np.unique(road).tolist():
        index = np.flatnonzero(road == edge)
        part = poses_on_road(
            f"{actor.on}/{edge}",
            actor,
            copies.candidates,
            copies.rows[index],
            begin.take(index),
            written.take(index),
            (sizes[0][index], sizes[1][index]),
        )
        names = ("x", "y", "heading", "start", "offset", "width", "lane", "backward",
                 "missing_lane")  # fmt: skip
        for into, name in zip(columns, names, strict=True):
            into[index] = getattr(part, name)
    x, y, heading, start, offset, width = found
    no_place = np.where((missing_lane != 0) & (no_place == 0), NoPlace.NO_LANE, no_place)
    return RoadPoses(x, y, heading, start, offset, lane, backward, road, lacking, width,
        missing_lane, no_place)  # fmt: skip


def _begin(
    actor: ScenarioActor, copies: CopyBatch, written: WrittenPlace, others: Others
) -> LaneStart:
    """Where along its road, and in which lane."""
    start = starts_of(actor, copies, others)
    if not isinstance(actor.at, PassCall):
        return LaneStart.of(start, _lanes(actor, copies, written, None))
    by = standing_of(actor, copies, others)
    lane = _lanes(actor, copies, written, by)
    backward = np.asarray(by.backward, bool).reshape(-1)
    return LaneStart(start, lane, np.asarray(by.offset, float).reshape(-1), backward, lane == 0)


def _lanes(
    actor: ScenarioActor, copies: CopyBatch, written: WrittenPlace, by: Standing | None
) -> Integers:
    """(R,) lane ids; 0 of what is in no lane. An agent on a road is in a lane unless it is said to
    be in none or beside the road."""
    value = option_value(actor, "lane", copies)
    if value is None and by is not None and not actor.is_beside_road:
        return np.asarray(by.lane, np.int64).reshape(-1)
    if value is None:
        is_agent = actor.name in copies.scenario.agents
        value = "none" if actor.is_beside_road or not is_agent else "first"
        on_foot = walk_at_side(actor, copies)
        if on_foot is not None:
            value = np.where(on_foot, ON_FOOT, value)
    words = [_word(item) for item in _items(value)]
    if not any(isinstance(word, str) for word in words):
        lane = np.rint(column(value, copies)).astype(np.int64)
        return over_the_middle(actor, copies, lane)
    numbers = [0 if isinstance(word, str) else word for word in words]
    found = np.rint(column(numbers, copies)).astype(np.int64)
    for word in sorted({word for word in words if isinstance(word, str)} - {"none"}):
        chosen = np.broadcast_to(np.array([item == word for item in words]), (copies.count,))
        against, sides = written.facing == "back", written.side
        ids = lanes_by_word(str(actor.on), actor, copies, word, against, sides)
        found[chosen] = ids[chosen]
    return found


def _items(value: Any) -> list[Any]:
    is_column = isinstance(value, np.ndarray) and value.dtype.kind in "OU"
    return value.reshape(-1).tolist() if is_column else [value]


def _word(value: Any) -> Any:
    """A word, or the name of a kind of lane."""
    return value.kind.rpartition(".")[2] if isinstance(value, PassCall) else value
